package majic.nav.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.zip.GZIPOutputStream;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CarmenLogTest {
    @TempDir
    private Path folder;

    private final List<Pose> odometry = new ArrayList<>();
    private final List<RangeScan> scans = new ArrayList<>();
    private final CarmenLog.Listener listener = new CarmenLog.Listener() {
        @Override
        public void odometry(double timeS, Pose pose) {
            odometry.add(pose);
        }

        @Override
        public void scan(RangeScan scan) {
            scans.add(scan);
        }
    };

    private void read(String text) throws IOException {
        CarmenLog.read(Files.writeString(folder.resolve("a.clf"), text), listener, share -> {});
    }

    private static String flaser(int count, String range, String poses) {
        return "FLASER " + count + (" " + range).repeat(count) + " " + poses + " 12.5 host 12.6\n";
    }

    @Test
    void metresAndRadiansBecomeMillimetresAndDegrees() throws IOException {
        read("# comment\nPARAM x\nODOM 1.5 -0.25 1.570796 0 0 0 10 host 11\n" + flaser(180, "2.5", "1 2 0 1 2 0"));

        assertThat(odometry).hasSize(1);
        assertThat(odometry.get(0).xMm()).isEqualTo(1500);
        assertThat(odometry.get(0).headingDeg()).isCloseTo(90, within(0.001));
        assertThat(scans.get(0).timeS()).isEqualTo(12.5);
        assertThat(scans.get(0).rangeMm(7)).isEqualTo(2500);
        assertThat(scans.get(0).odometry()).isEqualTo(new Pose(1000, 2000, 0));
    }

    @Test
    void theStepOfTheBeamsFollowsFromTheirNumber() throws IOException {
        read(flaser(180, "1", "0 0 0 0 0 0") + flaser(181, "1", "0 0 0 0 0 0") + flaser(361, "1", "0 0 0 0 0 0"));

        assertThat(scans)
                .extracting(scan -> scan.sensor().beams().get(1).mount().headingDeg())
                .containsExactly(-89.0, -89.0, -89.5);
        assertThat(scans.get(1).sensor().beams().get(180).mount().headingDeg()).isEqualTo(90);
    }

    @Test
    void theGreatestRangeOfTheScannerIsNoEcho() throws IOException {
        read(flaser(1, "81.83", "0 0 0 0 0 0"));

        assertThat(scans.get(0).rangeMm(0)).isInfinite();
    }

    @Test
    void aRangeOfZeroIsNoEchoAtTheRobot() throws IOException {
        read(flaser(1, "0", "0 0 0 0 0 0"));

        assertThat(scans.get(0).rangeMm(0)).isNaN();
    }

    @Test
    void aScannerInFrontOfTheCentreIsMountedThere() throws IOException {
        read(flaser(1, "1", "1.2 0 0 1 0 0"));

        assertThat(scans.get(0).sensor().beams().get(0).mount().xMm()).isCloseTo(200, within(0.01));
    }

    @Test
    void aCorrectedPoseIsNoPlaceOfTheScanner() throws IOException {
        read(flaser(1, "1", "9 5 0 1 0 0"));

        assertThat(scans.get(0).sensor().beams().get(0).mount().xMm()).isZero();
    }

    @Test
    void aWrittenScanIsReadAgain() throws IOException {
        RangeSensor sensor = RangeSensor.laser(new Pose(150, 20, 0), 5, -60, 30, 8000, 15);
        Pose pose = new Pose(1234, -567, 33);
        RangeScan scan = new RangeScan(sensor, 99.25, pose, 1000, 7999, 9000, 2500, 4);

        read(CarmenLog.line(99, pose) + "\n" + CarmenLog.line(scan) + "\n");

        RangeScan again = scans.get(0);
        assertThat(again.timeS()).isEqualTo(99.25);
        assertThat(again.odometry().distanceMm(pose)).isLessThan(0.01);
        assertThat(again.rangeMm(0)).isEqualTo(1000);
        assertThat(again.rangeMm(2)).isInfinite();
        assertThat(again.sensor().beams().get(4).mount().headingDeg()).isCloseTo(60, within(0.001));
        assertThat(again.sensor().beams().get(0).mount().yMm()).isCloseTo(20, within(0.01));
        assertThat(odometry.get(0).distanceMm(pose)).isLessThan(0.01);
    }

    @Test
    void aDamagedLineIsNamedWithWhatWouldBeRight() {
        assertThatThrownBy(() -> read("ODOM 0 0 0 0 0 0 1 a 1\nODOM 0 zero 0 0 0 0 1 a 1\n"))
                .hasMessage("a.clf, line 2: y (m) is 'zero', but has to be a number from -1000000 to 1000000");
        assertThatThrownBy(() -> read("FLASER 3 1 2"))
                .hasMessage("a.clf, line 1: the line ends in front of range 3 (m); a whole FLASER has ranges, two poses"
                        + " and the time behind their number");
        assertThatThrownBy(() -> read("FLASER 2000000000 1 2")).hasMessageContaining("from 1 to 8192");
        assertThatThrownBy(() -> read("ODOM " + "1".repeat(300_000))).hasMessageContaining("longer than 200000");
    }

    @Test
    void aCompressedLogThatIsCutOffIsReadUpToTheCut() throws IOException {
        Path file = folder.resolve("b.clf.gz");
        StringBuilder text = new StringBuilder();
        for (int line = 0; line < 20_000; line++) {
            text.append(CarmenLog.line(line, new Pose(line * 0.37, line * line * 0.001, line)))
                    .append('\n');
        }
        try (OutputStream out = new GZIPOutputStream(Files.newOutputStream(file))) {
            out.write(text.toString().getBytes(StandardCharsets.US_ASCII));
        }
        byte[] whole = Files.readAllBytes(file);
        Files.write(file, Arrays.copyOf(whole, whole.length / 2));

        assertThatThrownBy(() -> CarmenLog.read(file, listener, share -> {}))
                .hasMessageMatching("b.clf.gz, line \\d+: the compressed file is damaged or cut off here;.*");
        assertThat(odometry).hasSizeBetween(5000, 15_000);
    }
}
