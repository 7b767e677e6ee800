package majic.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.lang.reflect.Method;
import java.nio.charset.StandardCharsets;
import majic.simulation.SimulatedLab;
import majicsim.LabOptions;
import majicsim.world.Pose;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Runs the stand-alone programs of the programmer's guide with the lab; {@link EmbeddingTest} runs the ten lines. */
@Tag("jdk")
class ExamplesTest {
    private final PrintStream console = System.out;
    private final ByteArrayOutputStream said = new ByteArrayOutputStream();
    private SimulatedLab lab;

    @BeforeEach
    void open() throws Exception {
        lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), 1);
        System.setOut(new PrintStream(said, true, StandardCharsets.UTF_8));
    }

    @AfterEach
    void close() {
        System.setOut(console);
        lab.close();
    }

    private String run(String example, String... arguments) throws Exception {
        Method main = Class.forName(example).getMethod("main", String[].class);
        main.invoke(null, (Object) arguments);
        return said.toString(StandardCharsets.UTF_8);
    }

    private String address(String robot) {
        return lab.address(robot).orElseThrow().toString();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "WanderDog",
                "LineFollower",
                "MajicRace",
                "TenLines",
                "Wanderer",
                "RosWander",
                "RoverDrive",
                "PrintScans",
                "BuildMap",
                "GoThere"
            })
    void withoutAnAddressItPrintsItsUsage(String example) throws Exception {
        PrintStream errors = System.err;
        System.setErr(new PrintStream(said, true, StandardCharsets.UTF_8));
        try {
            assertThat(run(example)).startsWith("usage: " + example + " ").hasLineCount(1);
        } finally {
            System.setErr(errors);
        }
    }

    /** They race to obstacles, which takes less time than half a metre. */
    @Test
    void threeUnlikeRobotsRace() throws Exception {
        place("aibo", 3450, 1000);
        place("pioneer", 3200, 0);
        place("hemisson", 3850, -1000);
        assertThat(run("MajicRace", address("aibo"), address("pioneer"), address("hemisson")))
                .contains("Aibo: about ", "Pioneer: ", "Hemisson: about ");
    }

    private void place(String robot, double xMm, double yMm) {
        lab.simulators().place(robot, new Pose(xMm, yMm, 0));
    }

    @Test
    void aProgramRunsLinesOfMajicScript() throws Exception {
        assertThat(run("TwentyLines", "add " + address("pioneer"), "1 move 100", "1 get distanceFront"))
                .containsSubsequence("1 move 100: done", "1 distanceFront = clear");
    }
}
