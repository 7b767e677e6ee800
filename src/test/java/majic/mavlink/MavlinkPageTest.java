package majic.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import majic.bot.RobotPage;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** The page about MAVLink vehicles lists the parameters and commands of a rover as the driver describes them. */
class MavlinkPageTest {
    private static final Path PAGE = Path.of("docs", "robots", "mavlink.md");

    @AutoClose
    private final DrivenRover robot = new DrivenRover().ready();

    @Test
    void listsEveryParameter() throws IOException {
        assertThat(Files.readString(PAGE)).contains(RobotPage.parameters(robot.bot()));
    }

    @Test
    void listsEveryCommand() throws IOException {
        assertThat(Files.readString(PAGE)).contains(RobotPage.commands(robot.bot()));
    }
}
