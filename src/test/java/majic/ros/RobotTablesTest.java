package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import majic.environment.FolderSettings;
import majic.ros.graph.KnownRobots;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The user's table of robots. */
class RobotTablesTest {
    @TempDir
    private Path folder;

    private final List<String> alarms = new ArrayList<>();

    private KnownRobots read() {
        return RobotTables.read(new FolderSettings(folder), alarms::add);
    }

    @Test
    void theUsersRobotsComeBeforeMajicsOwn() throws IOException {
        Files.writeString(folder.resolve("ros-robots.txt"), "robot Lab Cart\n  when node cart*\n  speed 400\n");

        assertThat(read().names()).startsWith("Lab Cart").contains("TurtleBot3 Burger");
        assertThat(read().named("labcart").orElseThrow().speedMmPerSec()).isEqualTo(400);
        assertThat(alarms).isEmpty();
    }

    @Test
    void withoutAFileThereAreMajicsOwn() {
        assertThat(read().names()).isEqualTo(KnownRobots.builtIn().names());
        assertThat(alarms).isEmpty();
    }

    @Test
    void aWrongTableIsReportedWithItsLineAndNotUsed() throws IOException {
        Files.writeString(folder.resolve("ros-robots.txt"), "robot Lab Cart\n  wheels 4\n");

        assertThat(read().names()).isEqualTo(KnownRobots.builtIn().names());
        assertThat(alarms)
                .singleElement()
                .asString()
                .startsWith("the table of robots is not used: ros-robots.txt line 2: \"wheels\" is no property");
    }

    @Test
    void aTableThatCannotBeReadIsReported() throws IOException {
        Files.write(folder.resolve("ros-robots.txt"), new byte[] {'r', (byte) 0xFF, (byte) 0xFE});

        assertThat(read().names()).isEqualTo(KnownRobots.builtIn().names());
        assertThat(alarms).singleElement().asString().contains("ros-robots.txt cannot be read");
    }
}
