package majic.nav.file;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.nav.grid.NavigationMap;
import org.junit.jupiter.api.io.TempDir;

/** Arbitrary maps and logs: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see CONTRIBUTING.md). */
class NavFuzzTest {
    @TempDir
    private Path folder;

    @FuzzTest
    void anyLogIsReadOrRefusedWithItsPlace(byte[] log) throws IOException {
        Path file = Files.write(folder.resolve("odd.clf"), log);
        try {
            CarmenLog.read(
                    file,
                    new CarmenLog.Listener() {
                        @Override
                        public void odometry(double timeS, Pose pose) {
                            assertThat(timeS).isNotNegative();
                        }

                        @Override
                        public void scan(RangeScan scan) {
                            assertThat(CarmenLog.line(scan)).startsWith("ROBOTLASER1 ");
                        }
                    },
                    share -> assertThat(share).isBetween(0.0, 1.0));
        } catch (IOException e) {
            assertThat(e.getMessage()).matches("odd\\.clf, line \\d+: \\P{Cntrl}+");
        }
    }

    @FuzzTest
    void anyPioneerWorldIsReadOrRefused(byte[] map) throws IOException {
        readOrRefused(Files.write(folder.resolve("odd.map"), map));
    }

    @FuzzTest
    void anyYamlIsReadOrRefused(byte[] yaml) throws IOException {
        Files.writeString(folder.resolve("a.pgm"), "P2 2 1 255 0 254");
        readOrRefused(Files.write(folder.resolve("odd.yaml"), yaml));
    }

    @FuzzTest
    void anyPictureIsReadOrRefused(byte[] picture) throws IOException {
        Files.write(folder.resolve("odd.pgm"), picture);
        readOrRefused(
                Files.writeString(folder.resolve("odd.yaml"), "image: odd.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n"));
    }

    private static void readOrRefused(Path file) {
        try {
            NavigationMap map = MapFiles.read(file);
            assertThat(map.grid().width()).isPositive();
            assertThat(map.grid().state(0, 0)).isNotNull();
        } catch (IOException e) {
            assertThat(String.valueOf(e.getMessage())).matches("\\P{Cntrl}+");
        }
    }
}
