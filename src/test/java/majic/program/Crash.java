package majic.program;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Properties;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import majic.recorder.Recording;
import majic.recorder.RecordingFolder;

/** Kills a {@link CrashingSession} and reads what it has left in the user's folder. */
public final class Crash {
    private static final Pattern LOGGED =
            Pattern.compile("\\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d:\\d\\d\\.\\d{3} (\\w+) +(.*)");

    /** The setting after which the program counts as writing. */
    private static final int BEGUN = 20;

    private final Path folder;
    private final List<String> printed = new ArrayList<>();
    private long killedNanos;

    private Crash(Path folder) {
        this.folder = folder;
    }

    /**
     * Starts the program, and kills it some time after it has begun to write.
     *
     * @param folder the user's folder
     * @param afterMs how long it writes, ms
     * @param robots their addresses
     */
    public static Crash after(int afterMs, Path folder, String... robots) throws IOException, InterruptedException {
        Crash crash = new Crash(folder);
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-cp",
                System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")),
                CrashingSession.class.getName(),
                folder.toString()));
        command.addAll(List.of(robots));
        Process program = new ProcessBuilder(command).redirectErrorStream(true).start();
        try (BufferedReader out = program.inputReader()) {
            crash.readUntil(out, CrashingSession.KEPT + BEGUN);
            Thread killer = new Thread(() -> crash.kill(program, afterMs));
            killer.start();
            crash.readUntil(out, null);
            killer.join();
            crash.dropLastLine();
        } finally {
            program.destroyForcibly();
        }
        return crash;
    }

    private void kill(Process program, int afterMs) {
        try {
            Thread.sleep(afterMs);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        killedNanos = System.nanoTime();
        program.destroyForcibly();
    }

    private void readUntil(BufferedReader out, String last) throws IOException {
        try {
            for (String line = out.readLine(); line != null && !line.equals(last); line = out.readLine()) {
                printed.add(line);
            }
        } catch (IOException e) {
            if (killedNanos == 0) {
                throw e;
            }
        }
    }

    /** The kill may have come within it. */
    private void dropLastLine() {
        if (!printed.isEmpty()) {
            printed.remove(printed.size() - 1);
        }
    }

    /** Returns when it was killed, ns of the system's clock. */
    public long killedNanos() {
        return killedNanos;
    }

    /** Returns the lines of the session that were shown before the kill. */
    List<String> shown() {
        List<String> lines = new ArrayList<>(printed);
        lines.removeIf(line -> line.startsWith(CrashingSession.KEPT));
        return lines;
    }

    /** Returns the lines of the newest session log but for the commands; fails if one is not complete. */
    List<String> logged() throws IOException {
        String log = Files.readString(newest(folder.resolve("sessions")));
        if (!log.isEmpty() && !log.endsWith("\n")) {
            throw new IOException("half a line at the end: " + log.substring(log.lastIndexOf('\n') + 1));
        }
        List<String> lines = new ArrayList<>();
        for (String line : log.lines().toList()) {
            Matcher parts = LOGGED.matcher(line);
            if (!parts.matches()) {
                throw new IOException("half a line: " + line);
            }
            if (!parts.group(1).equals("command")) {
                lines.add(parts.group(2));
            }
        }
        return lines;
    }

    /** Returns how many lines were shown that are not in the log; fails if others are missing than the last ones. */
    public int missingLines() throws IOException {
        List<String> shown = shown();
        List<String> logged = logged();
        int common = Math.min(shown.size(), logged.size());
        if (!shown.subList(0, common).equals(logged.subList(0, common))) {
            throw new IOException("the log differs: " + logged + " instead of " + shown);
        }
        return shown.size() - common;
    }

    /** Returns the number of the newest setting that the program has reported as kept, −1 if there is none. */
    public int reportedSetting() {
        return printed.stream()
                .filter(line -> line.matches(CrashingSession.KEPT + "\\d+"))
                .mapToInt(line -> Integer.parseInt(line.substring(CrashingSession.KEPT.length())))
                .max()
                .orElse(-1);
    }

    /** Returns the settings that the next start reads. */
    public Properties settings() throws IOException {
        Properties settings = new Properties();
        try (Reader file = Files.newBufferedReader(folder.resolve("settings.properties"))) {
            settings.load(file);
        }
        return settings;
    }

    /** Opens the newest recording as a replay does. */
    public Recording recording() throws IOException {
        return Recording.read(newest(new RecordingFolder(folder.resolve("recordings")).path()));
    }

    private static Path newest(Path in) throws IOException {
        try (Stream<Path> files = Files.list(in)) {
            return files.max(Comparator.comparing(Crash::modified)).orElseThrow();
        }
    }

    private static long modified(Path file) {
        try {
            return Files.getLastModifiedTime(file).toMillis();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
