package majic.log;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import majic.bot.Value;
import majic.file.WholeFile;
import majic.text.LateLogger;
import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;

/**
 * Holds readings of parameters with their time, to be saved as comma-separated values. Keeps a few thousand in memory,
 * the rest in a temporary file of limited size that is deleted with the program's end. Thread-safe.
 */
public final class ParameterLog {
    private static final Logger LOG = LateLogger.of(ParameterLog.class);
    private static final String HEADER = "time_s,robot,parameter,value,unit";

    /** Greater than any number, and a number to those that read the file. */
    private static final String CLEAR = "inf";

    private static final int MOST_IN_MEMORY = 4096;

    /** About 400 MB: 11 days of ten readings a second. */
    private static final long MOST_ROWS = 10_000_000;

    private final long mostRows;
    private final List<String> rows = new ArrayList<>();
    private @Nullable Path spilled;
    private long written;
    private long lost;

    /** Creates a log without readings. */
    public ParameterLog() {
        this(MOST_ROWS);
    }

    ParameterLog(long mostRows) {
        this.mostRows = mostRows;
    }

    /**
     * Adds a reading. A number is written with its unit, {@code clear} as {@code inf}, a value that is not available as
     * nothing, and anything else as text.
     *
     * @param seconds time of the reading, on the clock of the session
     * @param robot the robot's number
     * @param parameter its name
     * @param value the reading
     */
    public synchronized void add(double seconds, int robot, String parameter, Value value) {
        rows.add(String.format(Locale.ROOT, "%.3f,%d,%s,%s", seconds, robot, quoted(parameter), columns(value)));
        if (rows.size() >= MOST_IN_MEMORY) {
            spill();
        }
    }

    /**
     * Returns whether there is nothing to save.
     *
     * @return true until the first reading
     */
    public synchronized boolean isEmpty() {
        return spilled == null && rows.isEmpty() && lost == 0;
    }

    /**
     * Writes all readings so far into a file, replacing it as a whole.
     *
     * @param file the file to write
     * @throws IOException if it cannot be written; the readings are kept and an existing file is unchanged. Also if
     *     readings are missing in the written file, because the disk was full or the log had reached its limit
     */
    public synchronized void save(Path file) throws IOException {
        WholeFile.replace(file, this::writeTo);
        if (lost > 0) {
            throw new IOException(lost + " readings are missing, there was no room for them");
        }
    }

    private void writeTo(OutputStream out) throws IOException {
        if (spilled == null) {
            out.write(lines(List.of(HEADER)));
        } else {
            Files.copy(spilled, out);
        }
        out.write(lines(rows));
    }

    private static byte[] lines(List<String> lines) {
        return lines.stream()
                .map(line -> line + System.lineSeparator())
                .collect(Collectors.joining())
                .getBytes(StandardCharsets.UTF_8);
    }

    private void spill() {
        if (written + rows.size() > mostRows) {
            lost += rows.size();
            rows.clear();
            return;
        }
        try {
            Path file = spilled == null ? newFile() : spilled;
            spilled = file;
            try (BufferedWriter out = Files.newBufferedWriter(file, StandardOpenOption.APPEND)) {
                for (String row : rows) {
                    out.write(row);
                    out.newLine();
                }
            }
            written += rows.size();
        } catch (IOException e) {
            lost += rows.size();
            LOG.log(Level.WARNING, "no room for the parameter log", e);
        }
        rows.clear();
    }

    private static Path newFile() throws IOException {
        Path file = Files.createTempFile("majic-parameters-", ".csv");
        file.toFile().deleteOnExit();
        Files.writeString(file, HEADER + System.lineSeparator());
        return file;
    }

    private static String columns(Value value) {
        if (value instanceof Value.Number number) {
            return number.amount() + "," + number.unit().symbol();
        }
        if (value instanceof Value.Clear) {
            return CLEAR + ",";
        }
        return value instanceof Value.Unknown ? "," : quoted(VisibleText.of(value.toString())) + ",";
    }

    private static String quoted(String text) {
        return text.matches("[^,\"\\r\\n]*") ? text : '"' + text.replace("\"", "\"\"") + '"';
    }
}
