package majic.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import majic.simulation.SimulatedLab;
import majicsim.LabOptions;
import majicsim.world.Pose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Tests that a program that only embeds a robot loads no window class and needs none of MAJIC's libraries. */
@Tag("jdk")
class EmbeddingTest {
    private static final List<String> UNNEEDED = List.of(
            " javax.swing.",
            " java.awt.",
            " com.mobilerobots.",
            " liburbi.",
            " majic.aibo.liburbi.",
            " majic.pioneer.aria.");

    private static final Pose NEAR_THE_WALL = new Pose(3400, 0, 0);

    private static CompletableFuture<String> tenLines;
    private static CompletableFuture<String> wanderer;

    /** The examples' robots take seconds for their ways, so both move at the same time. */
    @BeforeAll
    static void startBoth() {
        tenLines = CompletableFuture.supplyAsync(() -> run("-verbose:class", "TenLines"), EmbeddingTest::start);
        wanderer = CompletableFuture.supplyAsync(() -> run("-Xshare:auto", "Wanderer", "1"), EmbeddingTest::start);
    }

    private static void start(Runnable body) {
        new Thread(body, "example").start();
    }

    @Test
    void anEmbeddedRobotLoadsNeitherSwingNorAMakersLibrary() throws Exception {
        String loaded = tenLines.get();

        assertThat(loaded).contains("majic.pioneer.MajicPioneer ", "ahead: ");
        assertThat(loaded.lines().filter(line -> UNNEEDED.stream().anyMatch(line::contains)))
                .isEmpty();
    }

    @Test
    void theWandererTurnsWhereItsWayEnds() throws Exception {
        assertThat(wanderer.get()).containsPattern("ahead \\d+ mm.*\\nturned -?\\d+");
    }

    /** Runs an example with the Pioneer of an exact lab, near a wall; returns what it printed. */
    private static String run(String option, String example, String... further) {
        try (SimulatedLab lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), 1)) {
            lab.simulators().place("pioneer", NEAR_THE_WALL);
            List<String> command = new ArrayList<>(List.of(
                    Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                    "-XX:TieredStopAtLevel=1",
                    option,
                    "-cp",
                    System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")),
                    example,
                    lab.address("pioneer").orElseThrow().toString()));
            command.addAll(List.of(further));
            Process embedding =
                    new ProcessBuilder(command).redirectErrorStream(true).start();
            String printed = new String(embedding.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertThat(embedding.waitFor()).isZero();
            return printed;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }
}
