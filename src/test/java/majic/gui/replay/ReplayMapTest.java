package majic.gui.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import majic.recorder.RecordedText;
import majic.recorder.Recording;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The map that grows while a recording is replayed. */
class ReplayMapTest {
    @TempDir
    private Path folder;

    /** A robot that looks along y from (100, 0) on the floor; its laser has one beam straight ahead. */
    private ReplayMap map(String... scans) throws IOException {
        String[] lines = new String[scans.length + 3];
        lines[0] = "majic-recording\t1\t2026-11-22T11:30:05Z\t1\t0.000";
        lines[1] = "1.000\trobot\t2\tpioneer\tPioneer\tMobileRobots Pioneer\t250\t\t100\t0\t90\tpioneer";
        lines[2] = "\tsensor\t2\tlaser\t0 0 0 1 0 8000 15";
        System.arraycopy(scans, 0, lines, 3, scans.length);
        return new ReplayMap(Recording.read(RecordedText.write(folder.resolve("a.majicrec"), lines))
                .tracks());
    }

    private static String scan(double seconds, int rangeMm) {
        return "%.3f\tscan\t2\tlaser\t%.3f\t0 0 0\t%d".formatted(seconds, seconds, rangeMm);
    }

    @Test
    void itShowsWhatWasMeasuredUpToATimeAndNothingAfterJumpingBack() throws IOException {
        ReplayMap map = map(scan(2, 1000), scan(5, 3000));

        assertThat(map.at(1)).isNull();
        assertThat(map.at(3).map().grid().obstacleMm(100, 1000, 200)).isLessThan(60);
        assertThat(map.at(3).map().grid().obstacleMm(100, 3000, 200)).isInfinite();
        assertThat(map.at(6).map().grid().obstacleMm(100, 3000, 200)).isLessThan(60);
        assertThat(map.at(1)).isNull();
    }

    @Test
    void withoutScansThereIsNone() throws IOException {
        assertThat(map().at(9)).isNull();
    }
}
