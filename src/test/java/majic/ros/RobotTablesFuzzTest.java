package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import majic.environment.FolderSettings;
import majic.ros.graph.KnownRobot;
import majic.ros.graph.KnownRobots;
import majic.text.OneSentence;
import majic.text.VisibleText;
import org.junit.jupiter.api.io.TempDir;

/**
 * Arbitrary tables of robots: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see CONTRIBUTING.md).
 */
class RobotTablesFuzzTest {
    private static final int LONGEST_REPORT = 4000;

    private static final List<String> OWN = KnownRobots.builtIn().names();

    @TempDir
    private Path folder;

    private final List<String> alarms = new ArrayList<>();

    @FuzzTest
    void anyTableIsUsedInFrontOfMajicsOwnOrRefusedInOneSentence(byte[] table) throws IOException {
        alarms.clear();
        Files.write(folder.resolve("ros-robots.txt"), table);

        KnownRobots known = RobotTables.read(new FolderSettings(folder), alarms::add);

        List<String> names = known.names();
        List<String> added = names.subList(0, names.size() - OWN.size());
        assertThat(names.subList(added.size(), names.size())).isEqualTo(OWN);
        if (!alarms.isEmpty()) {
            assertThat(added).isEmpty();
            assertThat(alarms).singleElement().satisfies(OneSentence::check);
            assertThat(alarms.get(0))
                    .contains("ros-robots.txt")
                    .hasSizeLessThan(LONGEST_REPORT + folder.toString().length());
        }
        assertThat(added).allSatisfy(name -> canBeDriven(known.named(name)));
    }

    /** A robot of the table has positive limits; of several with one name, the first is found. */
    private static void canBeDriven(Optional<KnownRobot> found) {
        KnownRobot robot = found.orElseThrow();
        assertThat(robot.name()).isNotBlank().isEqualTo(VisibleText.of(robot.name()));
        assertThat(List.of(
                        robot.radiusMm(),
                        robot.speedMmPerSec(),
                        robot.turnDegPerSec(),
                        robot.accelerationMmPerSec2(),
                        robot.accelerationDegPerSec2(),
                        robot.slowestMmPerSec(),
                        robot.slowestDegPerSec()))
                .allMatch(limit -> limit > 0 && Double.isFinite(limit));
        assertThat(robot.slowestMmPerSec()).isLessThanOrEqualTo(robot.speedMmPerSec());
        assertThat(robot.afterCommands()).isNotBlank();
    }
}
