package majic.recorder;

import java.io.BufferedReader;
import java.io.EOFException;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipException;
import majic.recorder.RecordingFormat.Kind;
import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;

/**
 * Reads a file of a recording. A file whose end is missing, because the program was killed or still writes it, is read
 * up to that place. Lines of a kind that this version does not have are skipped.
 */
final class RecordingReader {
    private static final Logger LOG = System.getLogger(RecordingReader.class.getName());
    private static final int BUFFER = 1 << 16;
    private static final int LONGEST_LINE_BYTES = 1 << 20;
    private static final Map<String, Kind> KINDS =
            Arrays.stream(Kind.values()).collect(Collectors.toMap(Kind::word, kind -> kind));

    private final Path file;
    private final RecordingSink sink;
    private CutInput input = new CutInput(InputStream.nullInputStream());
    private double seconds;
    private long number = 1;

    private RecordingReader(Path file, RecordingSink sink) {
        this.file = file;
        this.sink = sink;
    }

    /**
     * Passes the content of a file to a sink. Blocks.
     *
     * @return the first line: what the file says about itself
     * @throws IOException if it cannot be read, or is no recording; the message says why, as half a sentence
     */
    static RecordingHead read(Path file, RecordingSink sink) throws IOException {
        return new RecordingReader(file, sink).read(true);
    }

    /** Reads only the first line of a file. */
    static RecordingHead readHead(Path file) throws IOException {
        return new RecordingReader(file, new RecordingSink() {}).read(false);
    }

    private RecordingHead read(boolean whole) throws IOException {
        try (BufferedReader lines = open()) {
            RecordingHead head = RecordingHead.parse(lines.readLine());
            if (whole) {
                seconds = head.beginS();
                readLines(lines);
            }
            return head;
        } catch (ZipException e) {
            throw new IOException("it is no recording of MAJIC, or it is damaged", e);
        } catch (EOFException e) {
            throw new IOException("it is empty", e);
        }
    }

    private BufferedReader open() throws IOException {
        InputStream compressed = Files.newInputStream(file);
        try {
            input = new CutInput(new GZIPInputStream(compressed, BUFFER));
            return new BufferedReader(new InputStreamReader(input, StandardCharsets.UTF_8), BUFFER);
        } catch (IOException e) {
            compressed.close();
            throw e;
        }
    }

    /**
     * Ends where the input is cut off, instead of failing there: a reader would drop what it has read ahead. Refuses a
     * line that would fill the memory.
     */
    private static final class CutInput extends FilterInputStream {
        private int lineBytes;

        CutInput(InputStream in) {
            super(in);
        }

        @Override
        public int read(byte[] bytes, int from, int length) throws IOException {
            try {
                int count = super.read(bytes, from, length);
                countLine(bytes, from, count);
                return count;
            } catch (EOFException e) {
                return -1;
            }
        }

        private void countLine(byte[] bytes, int from, int count) throws IOException {
            for (int at = from; at < from + count; at++) {
                lineBytes = bytes[at] == '\n' ? 0 : lineBytes + 1;
                if (lineBytes > LONGEST_LINE_BYTES) {
                    throw new IOException("it is damaged: it has a line of more than 1 MB");
                }
            }
        }

        /** Returns whether what was read so far ends with the end of a line. */
        boolean isAtLineEnd() {
            return lineBytes == 0;
        }
    }

    private void readLines(BufferedReader lines) throws IOException {
        String line = lines.readLine();
        for (String next = lines.readLine(); next != null; next = lines.readLine()) {
            number++;
            take(line);
            line = next;
        }
        takeLast(line);
    }

    /** The last line may be cut off, even in the middle of a number; then it is left out. */
    private void takeLast(@Nullable String line) {
        if (line != null && input.isAtLineEnd()) {
            try {
                take(line);
            } catch (IOException e) {
                LOG.log(Level.DEBUG, "the end is missing", e);
            }
        }
    }

    private void take(String line) throws IOException {
        String[] columns = RecordingFormat.split(line);
        try {
            RecordingFormat.require(columns, 2);
            if (!columns[0].isEmpty()) {
                seconds = Math.max(seconds, RecordingFormat.time(columns[0]));
            }
            sink.time(seconds);
            take(columns);
        } catch (IllegalArgumentException e) {
            throw new IOException(
                    "it is damaged in line " + number + ": " + VisibleText.of(String.valueOf(e.getMessage())), e);
        }
    }

    private void take(String[] columns) {
        Kind kind = KINDS.get(columns[1]);
        if (kind == null) {
            return;
        }
        switch (kind) {
            case WALL, TAPE -> sink.room(kind, places(columns, 4));
            case LAMP -> sink.room(kind, places(columns, 2));
            case ROBOT -> sink.robot(RecordingFormat.robot(columns, seconds));
            case PARAMETER ->
                sink.parameter(robot(columns), RecordingFormat.parameter(columns), RecordingFormat.isAbout(columns));
            case VALUE, STATUS, REPORT, TRUTH -> {
                RecordingFormat.require(columns, 5);
                sink.change(kind, robot(columns), columns[3], columns[4]);
            }
            case SENSOR -> sink.sensor(robot(columns), columns);
            case SCAN -> {
                RecordingFormat.require(columns, 4);
                sink.scan(robot(columns), columns);
            }
            case PICTURE -> {
                RecordingFormat.require(columns, 4);
                sink.picture(robot(columns), columns[3]);
            }
            case EVENT -> sink.event(RecordingFormat.event(columns, seconds));
            case LINE -> sink.line(RecordingFormat.line(columns, seconds));
            case MISSING -> {}
        }
    }

    private static double[] places(String[] columns, int count) {
        RecordingFormat.require(columns, 2 + count);
        return Arrays.stream(columns, 2, 2 + count)
                .mapToDouble(RecordingFormat::number)
                .toArray();
    }

    private static int robot(String[] columns) {
        RecordingFormat.require(columns, 3);
        return RecordingFormat.robotNumber(columns[2]);
    }
}
