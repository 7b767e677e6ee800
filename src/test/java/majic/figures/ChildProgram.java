package majic.figures;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Starts the measured programs with the options of MAJIC's launcher, in an empty user folder. */
final class ChildProgram {
    private static final String JAVA =
            Path.of(System.getProperty("java.home"), "bin", "java").toString();
    private static final Path TARGET = Path.of(System.getProperty("majic.target", "target"));
    private static final Path JAR = TARGET.resolve("majic.jar");
    private static final Path ARCHIVE = TARGET.resolve("figures.jsa");
    private static final Path OPTIONS = Path.of("config", "java.options");

    private final Path home;

    private ChildProgram(Path home) {
        this.home = home;
    }

    /** Makes the class-data archive anew, as the launcher does in the background of a first start. */
    static ChildProgram withClassData() throws IOException, InterruptedException {
        ChildProgram programs = new ChildProgram(Files.createTempDirectory("majic-figures"));
        Files.deleteIfExists(ARCHIVE);
        Process process = programs.process(
                        List.of(
                                JAVA,
                                "-XX:ArchiveClassesAtExit=" + ARCHIVE,
                                "-Xint",
                                "-XX:+UseSerialGC",
                                "-Xlog:disable"),
                        List.of("-jar", JAR.toString(), "class-data"))
                .start();
        if (process.waitFor() != 0 || !Files.exists(ARCHIVE)) {
            throw new IOException("the class-data archive cannot be made from " + JAR);
        }
        return programs;
    }

    /** Returns the time from the start of the process until its window is visible and painted. */
    double secondsUntilShown(String task, String... arguments) throws IOException {
        long began = System.nanoTime();
        Process process = measured(task, arguments);
        try (BufferedReader out = process.inputReader()) {
            String line = out.readLine();
            if (!MeasuredWindow.SHOWN.equals(line)) {
                throw new IOException(task + " has no window: " + line);
            }
            return (System.nanoTime() - began) / 1e9;
        } finally {
            end(process);
        }
    }

    /** Returns what a task prints. */
    List<String> lines(String task, String... arguments) throws IOException {
        Process process = measured(task, arguments);
        try (BufferedReader out = process.inputReader()) {
            return out.lines().toList();
        } finally {
            end(process);
        }
    }

    /** Starts the simulators alone, on free ports and without transmission times: an Aibo, a Hemisson and some Pioneers. */
    Lab lab(int pioneers) throws IOException {
        return lab(pioneers, "--exact");
    }

    /** Starts the same with noise and transmission times. */
    Lab usualLab(int pioneers) throws IOException {
        return lab(pioneers, "--seed=1");
    }

    private Lab lab(int pioneers, String noise) throws IOException {
        List<String> lab = List.of("-jar", JAR.toString(), "lab", noise, "--pioneer-port=0", "--pioneers=" + pioneers);
        return new Lab(process(List.of(JAVA, "@" + OPTIONS), lab).start(), pioneers + 2);
    }

    private Process measured(String task, String... arguments) throws IOException {
        String classPath = JAR + System.getProperty("path.separator") + TARGET.resolve("test-classes");
        List<String> rest = new ArrayList<>(List.of("-cp", classPath, MeasuredWindow.class.getName(), task));
        rest.addAll(List.of(arguments));
        return process(List.of(JAVA, "-XX:SharedArchiveFile=" + ARCHIVE, "@" + OPTIONS, "-Xlog:disable"), rest)
                .start();
    }

    private ProcessBuilder process(List<String> java, List<String> rest) {
        ProcessBuilder builder = new ProcessBuilder(new ArrayList<>(java));
        builder.command().addAll(rest);
        builder.environment().put("MAJIC_HOME", home.toString());
        builder.redirectError(ProcessBuilder.Redirect.INHERIT);
        return builder;
    }

    private static void end(Process process) {
        process.destroyForcibly();
        process.onExit().join();
    }

    /** A lab in a process of its own. */
    static final class Lab implements AutoCloseable {
        private static final int SETTLING_S = 15;
        private static final int MEASURED_S = 15;

        private final Process process;
        private final Map<String, String> addresses = new LinkedHashMap<>();

        private Lab(Process process, int robots) throws IOException {
            this.process = process;
            BufferedReader out = process.inputReader();
            while (addresses.size() < robots) {
                String[] words = out.readLine().split(" ");
                if (!words[0].endsWith("-pty")) {
                    addresses.put(words[0], words[1]);
                }
            }
        }

        /** Returns its processor time as a share of one core, once its code is compiled. */
        double percentOfACore() throws InterruptedException {
            Thread.sleep(SETTLING_S * 1000);
            long began = System.nanoTime();
            Duration before = processorTime();
            Thread.sleep(MEASURED_S * 1000);
            return 100.0 * processorTime().minus(before).toNanos() / (System.nanoTime() - began);
        }

        private Duration processorTime() {
            return process.info().totalCpuDuration().orElseThrow();
        }

        /** Returns the addresses of its Pioneers. */
        List<String> pioneers() {
            return addresses.entrySet().stream()
                    .filter(robot -> robot.getKey().startsWith("pioneer"))
                    .map(Map.Entry::getValue)
                    .toList();
        }

        /** Returns all its robots, each as its type and its address. */
        List<String> robots() {
            return addresses.entrySet().stream()
                    .map(robot -> robot.getKey().replaceFirst("\\d+$", "") + "=" + robot.getValue())
                    .toList();
        }

        @Override
        public void close() {
            end(process);
        }
    }
}
