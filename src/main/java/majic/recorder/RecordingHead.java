package majic.recorder;

import java.io.IOException;
import java.nio.file.Path;
import java.time.DateTimeException;
import java.time.Instant;
import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;

/**
 * The first line of a file of a recording. Immutable.
 *
 * @param begin the time of day at which the recording began
 * @param part the number of the file among those of the recording, from 1
 * @param beginS the time of the recording at which the file begins, seconds
 */
public record RecordingHead(Instant begin, int part, double beginS) {
    private static final int COLUMNS = 5;
    private static final Instant LATEST = Instant.parse("9999-01-01T00:00:00Z");

    /**
     * Reads the first line of a file. Blocks.
     *
     * @param file a file of a recording
     * @return what it says about itself
     * @throws IOException if it cannot be read, or is no recording; the message says why
     */
    public static RecordingHead read(Path file) throws IOException {
        return RecordingReader.readHead(file);
    }

    /**
     * Returns the time of day at a time of the recording.
     *
     * @param seconds since the recording began
     * @return with milliseconds
     */
    public Instant timeOfDay(double seconds) {
        return begin.plusMillis(Math.round(seconds * 1000));
    }

    String text() {
        return String.join(
                        "\t",
                        RecordingFormat.NAME,
                        RecordingFormat.VERSION,
                        begin.toString(),
                        "" + part,
                        ValueText.time(beginS))
                + "\n";
    }

    static RecordingHead parse(@Nullable String line) throws IOException {
        String[] columns = RecordingFormat.split(line == null ? "" : line);
        if (columns.length < COLUMNS || !columns[0].equals(RecordingFormat.NAME)) {
            throw new IOException("it is no recording of MAJIC");
        }
        if (!columns[1].equals(RecordingFormat.VERSION)) {
            throw new IOException("it was recorded by another version of MAJIC (format " + VisibleText.of(columns[1])
                    + "; this one reads format " + RecordingFormat.VERSION + ")");
        }
        try {
            return new RecordingHead(begin(columns[2]), Integer.parseInt(columns[3]), RecordingFormat.time(columns[4]));
        } catch (DateTimeException | IllegalArgumentException e) {
            throw new IOException("its first line is damaged", e);
        }
    }

    private static Instant begin(String text) {
        Instant begin = Instant.parse(text);
        if (begin.isBefore(Instant.EPOCH) || begin.isAfter(LATEST)) {
            throw new IllegalArgumentException(text + " is not a time of day of a recording");
        }
        return begin;
    }
}
