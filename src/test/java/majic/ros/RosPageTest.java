package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import majic.bot.RobotPage;
import majic.inlab.LabRig;
import majic.inlab.LabRobot;
import majic.ros.graph.KnownRobots;
import org.junit.jupiter.api.Test;

/** The page about ROS robots lists the parameters of the simulated one as the driver describes them. */
class RosPageTest {
    private static final Path PAGE = Path.of("docs", "robots", "ros.md");

    @Test
    void listsEveryParameter() throws IOException {
        try (LabRobot robot = new LabRobot("ros", LabRig.exactWithRos("2"))) {
            robot.bot().connect();

            assertThat(Files.readString(PAGE)).contains(RobotPage.parameters(robot.bot()));
        }
    }

    @Test
    void listsEveryCommand() throws IOException {
        try (LabRobot robot = new LabRobot("ros", LabRig.exactWithRos("2"))) {
            robot.bot().connect();

            assertThat(Files.readString(PAGE)).contains(RobotPage.commands(robot.bot()));
        }
    }

    @Test
    void namesEveryMakeOfTheTable() throws IOException {
        assertThat(Files.readString(PAGE))
                .contains(KnownRobots.builtIn().names().stream()
                        .map(name ->
                                name.replaceFirst(" \\(ROS 2\\)| fake.*", "").replaceFirst(" (Burger|Waffle)$", ""))
                        .toList());
    }
}
