package majic.figures;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Starts the measured programs with the options of MAJIC's launcher, in an empty user folder. */
final class ChildProgram {
    private static final String JAVA =
            Path.of(System.getProperty("java.home"), "bin", "java").toString();
    private static final Path TARGET = Path.of(System.getProperty("majic.target", "target"));
    private static final Path JAR = TARGET.resolve("majic.jar");
    private static final Path ARCHIVE = TARGET.resolve("figures.jsa");
    /** As in config/tools.sh. */
    private static final String LONGEST_POLL_MS = "10";

    private static final Path OPTIONS = Path.of("config", "java.options");

    private final Path home;

    private ChildProgram(Path home) {
        this.home = home;
    }

    /** Makes an empty user folder. */
    static ChildProgram create() throws IOException {
        return new ChildProgram(Files.createTempDirectory("majic-figures"));
    }

    /** Makes the class-data archive anew, as the launcher does in the background of a first start. */
    ChildProgram withClassData() throws IOException, InterruptedException {
        Files.deleteIfExists(ARCHIVE);
        Process process = process(
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
        return this;
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

    /**
     * Returns what a task prints.
     *
     * @throws IOException if it fails; its own error is in the error output
     */
    List<String> lines(String task, String... arguments) throws IOException {
        return lines(measured(task, arguments));
    }

    private static List<String> lines(Process process) throws IOException {
        try (BufferedReader out = process.inputReader()) {
            List<String> lines = out.lines().toList();
            int code = process.onExit().join().exitValue();
            if (code != 0) {
                throw new IOException("a program that measures has ended with exit code " + code);
            }
            return lines;
        } finally {
            end(process);
        }
    }

    /**
     * Starts the simulators alone, on free ports and without transmission times: an Aibo, a Hemisson and some Pioneers.
     */
    Lab lab(int pioneers) throws IOException {
        return lab(pioneers, "--exact");
    }

    /** Starts the same with noise and transmission times. */
    Lab usualLab(int pioneers) throws IOException {
        return lab(pioneers, "--seed=1");
    }

    /** Starts a robot behind a rosbridge server, beside one robot of each other make, with noise. */
    Lab rosLab() throws IOException {
        List<String> lab = List.of("-jar", JAR.toString(), "lab", "--seed=1", "--pioneer-port=0", "--ros");
        return new Lab(process(List.of(JAVA, "@" + OPTIONS), lab).start(), Lab.ROS, 1);
    }

    /** Starts rovers that speak MAVLink, beside one robot of each other make, with noise. */
    Lab mavlinkLab(int rovers) throws IOException {
        String kinds = String.join(",", Collections.nCopies(rovers, "rover+ready"));
        List<String> lab = List.of("-jar", JAR.toString(), "lab", "--seed=1", "--pioneer-port=0", "--mavlink=" + kinds);
        return new Lab(process(List.of(JAVA, "@" + OPTIONS), lab).start(), Lab.MAVLINK, rovers);
    }

    private Lab lab(int pioneers, String noise) throws IOException {
        List<String> lab = List.of("-jar", JAR.toString(), "lab", noise, "--pioneer-port=0", "--pioneers=" + pioneers);
        return new Lab(process(List.of(JAVA, "@" + OPTIONS), lab).start(), Lab.ROBOT, pioneers + 2);
    }

    /** Returns what a program without a window prints. */
    List<String> lines(Class<?> main, List<String> arguments) throws IOException {
        return lines(process(List.of(JAVA, "@" + OPTIONS), classAndArguments(main, arguments))
                .start());
    }

    /** Returns what a program without a window prints that runs with the class path of this one. */
    List<String> linesOfBuild(Class<?> main, List<String> arguments) throws IOException {
        List<String> all = new ArrayList<>(List.of("-cp", System.getProperty("java.class.path"), main.getName()));
        all.addAll(arguments);
        return lines(
                process(List.of(JAVA, "-Djdk.attach.allowAttachSelf=true"), all).start());
    }

    /** Starts a program with a team whose robots report while it is connected; connects to none yet. */
    Reporting reporting(List<String> addresses) throws IOException {
        return new Reporting(process(List.of(JAVA, "@" + OPTIONS), classAndArguments(ReportingTeam.class, addresses))
                .start());
    }

    private Process measured(String task, String... arguments) throws IOException {
        List<String> rest = new ArrayList<>(List.of(task));
        rest.addAll(List.of(arguments));
        return process(
                        List.of(JAVA, "-XX:SharedArchiveFile=" + ARCHIVE, "@" + OPTIONS, "-Xlog:disable"),
                        classAndArguments(MeasuredWindow.class, rest))
                .start();
    }

    private static List<String> classAndArguments(Class<?> main, List<String> arguments) {
        String classPath = JAR + System.getProperty("path.separator") + TARGET.resolve("test-classes");
        List<String> all = new ArrayList<>(List.of("-cp", classPath, main.getName()));
        all.addAll(arguments);
        return all;
    }

    private ProcessBuilder process(List<String> java, List<String> rest) {
        ProcessBuilder builder = new ProcessBuilder(new ArrayList<>(java));
        builder.command().addAll(rest);
        builder.environment().put("MAJIC_HOME", home.toString());
        builder.environment().put("_AWT_MAX_POLL_TIMEOUT", LONGEST_POLL_MS);
        builder.redirectError(ProcessBuilder.Redirect.INHERIT);
        return builder;
    }

    private static void end(Process process) {
        process.destroyForcibly();
        process.onExit().join();
    }

    private static Duration processorTime(Process process) {
        return process.info().totalCpuDuration().orElseThrow();
    }

    /** A team in a process of its own that does nothing but receive reports while it is connected. */
    static final class Reporting implements AutoCloseable {
        private final Process process;
        private final BufferedReader answers;

        private Reporting(Process process) {
            this.process = process;
            this.answers = process.inputReader();
        }

        /** Returns when all robots are connected. */
        void connect() throws IOException {
            demand(ReportingTeam.CONNECT, ReportingTeam.CONNECTED);
        }

        /** Returns when the program has closed the connections. */
        void disconnect() throws IOException {
            demand(ReportingTeam.DISCONNECT, ReportingTeam.DISCONNECTED);
        }

        private void demand(char command, String expected) throws IOException {
            process.getOutputStream().write(command);
            process.getOutputStream().flush();
            String answer = answers.readLine();
            if (!expected.equals(answer)) {
                throw new IOException("a team is not " + expected + ": " + answer);
            }
        }

        /** Returns the processor time since its start. */
        Duration processorTime() {
            return ChildProgram.processorTime(process);
        }

        @Override
        public void close() {
            end(process);
        }
    }

    /** A lab in a process of its own. */
    static final class Lab implements AutoCloseable {
        private static final int SETTLING_S = 15;
        private static final int MEASURED_S = 15;

        private static final Pattern ROBOT = Pattern.compile("(aibo|hemisson|pioneer)\\d* (127\\.0\\.0\\.1:\\d+)");
        private static final Pattern ROS = Pattern.compile("(ros)\\d* (127\\.0\\.0\\.1:\\d+)");
        private static final Pattern MAVLINK = Pattern.compile("(mavlink)\\d* (127\\.0\\.0\\.1:\\d+)");

        private final Process process;
        private final List<String> addresses = new ArrayList<>();

        /** Reads the addresses of the wanted robots; serial lines are left out. */
        private Lab(Process process, Pattern wanted, int count) throws IOException {
            this.process = process;
            BufferedReader out = process.inputReader();
            for (String line = out.readLine(); line != null; line = out.readLine()) {
                Matcher robot = wanted.matcher(line);
                if (robot.matches()) {
                    addresses.add(robot.group(1) + "://" + robot.group(2));
                }
                if (addresses.size() == count) {
                    return;
                }
            }
            throw new IOException("the lab has ended with the robots " + addresses);
        }

        /** Returns the addresses of all its robots, as users type them. */
        List<String> addresses() {
            return addresses;
        }

        /** Returns its processor time as a share of one core, once its code is compiled. */
        double percentOfACore() throws InterruptedException {
            Thread.sleep(SETTLING_S * 1000);
            long began = System.nanoTime();
            Duration before = processorTime(process);
            Thread.sleep(MEASURED_S * 1000);
            return 100.0 * processorTime(process).minus(before).toNanos() / (System.nanoTime() - began);
        }

        /** Returns the number of its process. */
        long pid() {
            return process.pid();
        }

        /** Returns the addresses of its Pioneers. */
        List<String> pioneers() {
            return addresses.stream()
                    .filter(address -> address.startsWith("pioneer:"))
                    .toList();
        }

        @Override
        public void close() {
            end(process);
        }
    }
}
