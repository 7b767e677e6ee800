package majic.gui.plot.data;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import majic.recorder.RecordedText;
import majic.recorder.Recording;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RecordedSourceTest {
    @TempDir
    private Path folder;

    /** A part of 10 s in which x grows from the number of seconds, and a command begins in the middle. */
    private Recording part(int number) throws Exception {
        int beginS = 10 * (number - 1);
        Path file = RecordedText.write(
                folder.resolve("part" + number),
                "majic-recording\t1\t2026-11-22T11:30:05Z\t" + number + "\t" + beginS + ".000",
                "\trobot\t1\ttoy\tToy\tToys\t200\t\t0\t0\t0\t",
                "\tparameter\t1\tx\tnumber\tmm\t\t-1.0E9\t1.0E9\tahead",
                "\tvalue\t1\tx\t" + beginS,
                beginS + 5 + ".000\tevent\t1\tbegun\t1 move " + number,
                beginS + 9 + ".900\tvalue\t1\tx\t" + (beginS + 9));
        return Recording.read(file);
    }

    @Test
    void aCurveKeepsTheReadingsOfThePartsBeforeAndAfter() throws Exception {
        RecordedSource source = new RecordedSource(part(2), () -> 15);
        Samples samples = new Samples();
        source.feed(source.quantities(1, "x").get(0), samples);
        source.show(part(3));
        source.show(part(1));
        assertThat(samples.at(0)).isEqualTo(0);
        assertThat(samples.at(10)).isEqualTo(10);
        assertThat(samples.at(29.9)).isEqualTo(29);
    }

    @Test
    void theLastValueIsHeldUntilTheEndOfThePart() throws Exception {
        Path file = RecordedText.write(
                folder.resolve("part"),
                "majic-recording\t1\t2026-11-22T11:30:05Z\t1\t0.000",
                "\trobot\t1\ttoy\tToy\tToys\t200\t\t0\t0\t0\t",
                "\tparameter\t1\tx\tnumber\tmm\t\t-1.0E9\t1.0E9\tahead",
                "\tvalue\t1\tx\t5",
                "8.000\tline\tnotice\tthe end");
        RecordedSource source = new RecordedSource(Recording.read(file), () -> 8);
        Samples samples = new Samples();
        source.feed(source.quantities(1, "x").get(0), samples);
        assertThat(samples.within(new Span(0, 8)).times()).containsExactly(0, 8);
    }

    @Test
    void theMarksOfAllPartsAreInTheOrderOfTheirTimes() throws Exception {
        RecordedSource source = new RecordedSource(part(2), () -> 15);
        source.show(part(1));
        source.show(part(2));
        assertThat(source.marks(0, 100)).extracting(PlotMark::seconds).containsExactly(5.0, 15.0);
    }

    @Test
    void aRecordedStopOfAllRobotsIsMarkedAsStop() throws Exception {
        Path file = RecordedText.write(
                folder.resolve("stopped"),
                "majic-recording\t1\t2026-11-22T11:30:05Z\t1\t0.000",
                "2.000\tevent\t0\tstop\tall robots",
                "8.000\tline\tnotice\tthe end");
        RecordedSource source = new RecordedSource(Recording.read(file), () -> 8);
        assertThat(source.marks(0, 8)).extracting(PlotMark::text).containsExactly("STOP");
    }
}
