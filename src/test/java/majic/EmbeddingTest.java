package majic;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import majicsim.LabOptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A program that only embeds a robot loads no window class and needs none of the program's libraries. */
@Timeout(60)
class EmbeddingTest {
    @Test
    void anEmbeddedRobotLoadsNoSwing() throws Exception {
        try (SimulatedLab lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), 1)) {
            Process embedding = new ProcessBuilder(
                            Path.of(System.getProperty("java.home"), "bin", "java")
                                    .toString(),
                            "-verbose:class",
                            "-Xshare:off",
                            "-cp",
                            System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")),
                            "TenLines",
                            lab.address("pioneer").orElseThrow().toString())
                    .redirectErrorStream(true)
                    .start();
            String loaded = new String(embedding.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

            assertThat(embedding.waitFor()).isZero();
            assertThat(loaded).contains("majic.pioneer.MajicPioneer ", "ahead: ");
            assertThat(loaded.lines().filter(line -> line.contains(" javax.swing.") || line.contains(" java.awt.")))
                    .isEmpty();
        }
    }
}
