package majic.cli;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.stream.Collectors;
import java.util.zip.GZIPOutputStream;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.file.WholeFile;
import majic.nav.file.CarmenLog;
import majic.program.UsageException;
import majic.recorder.RecordedScans;
import majic.recorder.RecordingFolder;
import org.jspecify.annotations.Nullable;

/** The odometry and the laser scans in a CARMEN log, or of one robot in a recording. */
interface ScanLog {
    /**
     * Reads them. Blocks; the listener is called on this thread.
     *
     * @param progress called with the share that has been read, 0 to 1
     * @throws IOException if a file cannot be read or is damaged: one sentence
     */
    void read(CarmenLog.Listener listener, DoubleConsumer progress) throws IOException;

    /**
     * Opens a file. Blocks.
     *
     * @param robot the number of a robot in a recording; null if the recording has scans of one robot only
     * @param notices receives a sentence if only a part of the scans is read
     * @throws IOException if the recording cannot be read, or has no such scans: one sentence
     */
    static ScanLog of(Path file, @Nullable Integer robot, Consumer<String> notices) throws IOException {
        if (!file.toString().endsWith(RecordingFolder.ENDING)) {
            if (robot != null) {
                throw new UsageException("--robot goes with a recording, a file *" + RecordingFolder.ENDING);
            }
            return (listener, progress) -> CarmenLog.read(file, listener, progress);
        }
        RecordedScans scans = chosen(file, robot, notices);
        return (listener, progress) -> {
            int[] read = {0};
            scans.read(scan -> {
                listener.scan(scan);
                read[0]++;
                progress.accept(Math.min(1, (double) read[0] / scans.count()));
            });
        };
    }

    private static RecordedScans chosen(Path file, @Nullable Integer robot, Consumer<String> notices)
            throws IOException {
        List<RecordedScans> all = RecordedScans.in(file);
        if (all.isEmpty()) {
            throw new IOException(file.getFileName() + " has no scans; a recording of a robot that was driven with a"
                    + " laser scanner would be right, by a MAJIC that records scans");
        }
        List<Integer> numbers = all.stream()
                .map(scans -> scans.robot().number())
                .distinct()
                .sorted()
                .toList();
        int wanted = robot != null ? robot : numbers.get(0);
        if (robot == null && numbers.size() > 1 || !numbers.contains(wanted)) {
            throw new UsageException(file.getFileName() + " has scans of robot "
                    + numbers.stream().map(String::valueOf).collect(Collectors.joining(", "))
                    + "; one of these is right, as in --robot " + numbers.get(0));
        }
        List<RecordedScans> of =
                all.stream().filter(scans -> scans.robot().number() == wanted).toList();
        RecordedScans most =
                of.stream().max(Comparator.comparingInt(RecordedScans::count)).orElseThrow();
        if (of.size() > 1) {
            int count = of.stream().mapToInt(RecordedScans::count).sum();
            notices.accept("robot " + wanted + " was connected " + of.size()
                    + " times; the connection with the most scans is read, " + most.count() + " of " + count);
        }
        return most;
    }

    /**
     * Writes a CARMEN log, compressed by gzip if its name ends with {@code .gz}: a line of odometry for each one and
     * for each scan. Blocks.
     *
     * @throws IOException if a file cannot be read or written, or a CARMEN log cannot describe the scanner: one
     *     sentence
     */
    default void write(Path carmenLog) throws IOException {
        boolean compressed = carmenLog.toString().toLowerCase(Locale.ROOT).endsWith(".gz");
        WholeFile.replace(carmenLog, out -> {
            OutputStream bytes = compressed ? new GZIPOutputStream(out) : out;
            Writer lines = new BufferedWriter(new OutputStreamWriter(bytes, StandardCharsets.US_ASCII));
            try {
                read(new LineWriter(lines), share -> {});
            } catch (UncheckedIOException e) {
                throw e.getCause();
            }
            lines.flush();
            if (bytes instanceof GZIPOutputStream gzip) {
                gzip.finish();
            }
        });
    }

    /** Writes lines of a CARMEN log. */
    record LineWriter(Writer lines) implements CarmenLog.Listener {
        @Override
        public void odometry(double timeS, Pose pose) {
            write(CarmenLog.line(timeS, pose));
        }

        @Override
        public void scan(RangeScan scan) {
            odometry(scan.timeS(), scan.odometry());
            try {
                write(CarmenLog.line(scan));
            } catch (IllegalArgumentException e) {
                throw new UncheckedIOException(new IOException(e.getMessage(), e));
            }
        }

        private void write(String line) {
            try {
                lines.write(line + "\n");
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
    }
}
