package majic.figures;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import majic.figures.nav.GoToFigures;
import majic.figures.nav.MappingFigures;
import majic.figures.nav.OfficeFigures;
import majic.figures.nav.ReactionFigures;
import majic.figures.nav.TrafficFigures;
import majic.figures.ways.OneUserClasses;
import majic.figures.ways.Ways;
import majic.link.Loopback;
import majic.shared.broker.Mosquitto;

/**
 * Measures MAJIC, started as its launcher starts it, and prints the figures with the values they should not exceed.
 * Each figure comes from a program of its own; run it on a quiet computer. The arguments select figures: {@code start},
 * {@code idle}, {@code events}, {@code large}, {@code line}, {@code memory}, {@code stop}, {@code flood}, {@code lab},
 * {@code load}, {@code crash}, {@code shared}, {@code ros}, {@code ways}, {@code mapping}, {@code localisation},
 * {@code goto}, {@code mavlink}; without arguments all are measured. {@code shared:10x100} measures one row of
 * {@code shared}, with 10 desks and 100 robots, and {@code lab:500} one row of {@code lab}. The address of a robot
 * behind a rosbridge server, such as {@code ros://127.0.0.1:9090}, measures what {@code ros} does with that robot,
 * which turns to and fro by up to 12 degrees.
 */
public final class Figures {
    /** The robots of the window that {@code large} measures. */
    static final int LARGE_TEAM = 200;

    private static final int STARTS = 9;
    private static final int NINE_PIONEERS = 9;
    private static final List<Integer> TEAMS = List.of(1, 10, 100, 500);
    private static final int MIXED_LABS = 6;
    private static final int PIONEERS_OF_MIXED_LAB = 8;

    /** Desks and robots of each row of {@code shared}. */
    private static final int[][] SHARED = {{1, 10}, {10, 100}, {50, 200}, {50, 1000}};

    private static final String SHARED_ROW = "shared:";

    private static final int MOST_OF_A_LAB = 500;

    private static final List<Integer> LABS = List.of(1, 10, 45, 100, 500);
    private static final String LAB_ROW = "lab:";
    private static final List<String> ALL = List.of(
            "start",
            "idle",
            "events",
            "large",
            "line",
            "memory",
            "stop",
            "flood",
            "lab",
            "load",
            "crash",
            "shared",
            "ros",
            "ways",
            "mapping",
            "localisation",
            "goto",
            "mavlink");

    private static final List<String> WITHOUT_WINDOW =
            List.of("lab", "load", "crash", "shared", "ros", "ways", "mapping", "localisation", "goto", "mavlink");

    private final ChildProgram programs;

    private Figures(ChildProgram programs) {
        this.programs = programs;
    }

    /** Measures and prints. */
    public static void main(String[] names) throws IOException, InterruptedException {
        List<String> wanted = names.length == 0 ? ALL : List.of(names);
        ChildProgram programs = ChildProgram.create();
        Figures figures =
                new Figures(wanted.stream().allMatch(Figures::isWithoutWindow) ? programs : programs.withClassData());
        for (String name : wanted) {
            switch (name) {
                case "start" -> figures.start();
                case "idle" -> figures.idle();
                case "events" -> figures.events();
                case "large" -> figures.large();
                case "line" -> figures.line();
                case "memory" -> figures.memory();
                case "stop" -> figures.stop();
                case "flood" -> figures.flood();
                case "lab" -> figures.lab(LABS);
                case "load" -> figures.load();
                case "crash" -> figures.crash();
                case "shared" -> figures.shared(SHARED);
                case "ros" -> figures.ros();
                case "ways" -> figures.ways();
                case "mapping" -> figures.mapping();
                case "localisation" -> figures.localisation();
                case "goto" -> figures.goTo();
                case "mavlink" -> figures.mavlink();
                default -> figures.measureNamed(name);
            }
        }
    }

    private static boolean isWithoutWindow(String name) {
        return WITHOUT_WINDOW.contains(name) || name.startsWith(SHARED_ROW) || name.startsWith(LAB_ROW);
    }

    private void measureNamed(String name) throws IOException, InterruptedException {
        if (name.startsWith(LAB_ROW)) {
            lab(List.of(Integer.parseInt(name.substring(LAB_ROW.length()))));
        } else if (name.startsWith(SHARED_ROW)) {
            String[] row = name.substring(SHARED_ROW.length()).split("x");
            shared(new int[][] {{Integer.parseInt(row[0]), Integer.parseInt(row[1])}});
        } else {
            ros(name);
        }
    }

    /** Alternates the three starts, so that a change of the computer's load affects all of them. */
    private void start() throws IOException, InterruptedException {
        Map<String, List<Double>> seconds = new TreeMap<>();
        for (int round = 0; round <= STARTS; round++) {
            double bare = programs.secondsUntilShown("bare");
            double majic = programs.secondsUntilShown("majic");
            double lab = programs.secondsUntilShown("majic", "--lab");
            if (round > 0) {
                add(seconds, "bare", bare);
                add(seconds, "majic", majic);
                add(seconds, "lab", lab);
            }
        }
        double bare = median(seconds, "bare");
        say("start to a visible window, median of " + STARTS);
        say("  bare FlatLaf frame %.2f s", bare);
        say(
                "  majic       %.2f s, %.2f times the bare frame (at most 1.5)",
                median(seconds, "majic"), median(seconds, "majic") / bare);
        say(
                "  majic --lab %.2f s, %.2f times the bare frame (at most 1.8)",
                median(seconds, "lab"), median(seconds, "lab") / bare);
    }

    private void idle() throws IOException, InterruptedException {
        say("idle window with the lab and its three robots (at most 8 % of a core)");
        programs.lines("idle", "--lab").forEach(line -> say("  " + line));
    }

    private void events() throws IOException, InterruptedException {
        say("event dispatch thread with 20 robots (99 of 100 at most 16 ms, longest 50 ms)");
        try (ChildProgram.Lab further = programs.lab(NINE_PIONEERS)) {
            List<String> arguments = new ArrayList<>(List.of("--lab", "--pioneers=" + NINE_PIONEERS));
            further.pioneers().forEach(address -> arguments.addAll(List.of("--add", address)));
            programs.lines("events", arguments.toArray(String[]::new)).forEach(line -> say("  " + line));
        }
    }

    private void large() throws IOException, InterruptedException {
        say("event dispatch thread with " + LARGE_TEAM + " robots");
        programs.lines("large", "--lab", "--pioneers=" + (LARGE_TEAM - 2), "--max-robots=" + LARGE_TEAM)
                .forEach(line -> say("  " + line));
    }

    private void line() throws IOException, InterruptedException {
        say("processor time of the event dispatch thread for one action of the command line (at most 50 ms)");
        programs.lines("line", "--lab").forEach(line -> say("  " + line));
    }

    private void memory() throws IOException, InterruptedException {
        say("memory in use after collection, over an hour of the lab");
        programs.lines("memory", "--lab", "--speed", "30").forEach(line -> say("  " + line));
    }

    private void stop() throws IOException, InterruptedException {
        say("STOP of 20 robots, of which 10 never read (99 of 100 at most 20 ms; the others named within 1 s)");
        try (ChildProgram.Lab lab = programs.lab(8)) {
            programs.lines("stop", lab.addresses().toArray(String[]::new)).forEach(line -> say("  " + line));
        }
    }

    /** Connects plain clients to all Pioneers of labs without a window; the Aibo and the Hemisson have none. */
    private void lab(List<Integer> counts) throws IOException, InterruptedException {
        say("processor time of a lab with Pioneers that are all connected (each at most 0.05 % of a core at 500)");
        for (int count : counts) {
            try (ChildProgram.Lab lab = programs.usualLab(count);
                    PioneerClients clients = PioneerClients.connect(lab.pioneers())) {
                double atRest = lab.percentOfACore();
                clients.drive();
                double driving = lab.percentOfACore();
                say(
                        "  %3d Pioneers at rest %5.1f %%, each %.3f %%; driving %5.1f %%, each %.3f %%;"
                                + " %.1f reports a second each",
                        count, atRest, atRest / count, driving, driving / count, clients.reportsPerSecond());
            }
        }
    }

    private void flood() throws IOException {
        say("STOP from one program beside 300 others at --listen");
        programs.lines("flood").forEach(line -> say("  " + line));
    }

    /** Measures teams of Pioneers, then a team of 60 robots of all makes. */
    private void load() throws IOException, InterruptedException {
        say("teams without a window that report in turns (a Pioneer at most 0.15 % of a core, flat within 20 %)");
        FurtherRobots.measure(programs).forEach(line -> say("  " + line));
        say("one team at a time: 99 of 100 commands on the link within 1 ms with 100 robots on 2 cores,");
        say("at most 100 KB of heap a Pioneer");
        say(LoadTable.head());
        LoadTable table = new LoadTable();
        for (int robots : TEAMS) {
            try (ChildProgram.Lab lab = programs.usualLab(robots)) {
                say(table.row(teamLoad(lab.pioneers())));
            }
        }
        say(mixedTeam());
    }

    private String mixedTeam() throws IOException {
        List<ChildProgram.Lab> labs = new ArrayList<>();
        try {
            List<String> addresses = new ArrayList<>();
            for (int number = 0; number < MIXED_LABS; number++) {
                labs.add(programs.usualLab(PIONEERS_OF_MIXED_LAB));
                addresses.addAll(labs.get(number).addresses());
            }
            return LoadTable.single(teamLoad(addresses));
        } finally {
            labs.forEach(ChildProgram.Lab::close);
        }
    }

    private String teamLoad(List<String> addresses) throws IOException {
        return programs.lines(TeamLoad.class, addresses).get(0);
    }

    /** Measures desks that share robots over Mosquitto, with more desks and robots from row to row. */
    private void shared(int[][] rows) throws IOException, InterruptedException {
        say("robots shared over Mosquitto; times in ms, processor time as a share of one core, bytes a robot");
        say("(commands at most 2 times the bare messages of the same size, processor time and bytes a robot flat)");
        say("written: the system of the robot's desk has taken the bytes; arrived: they were read at the robot's end");
        if (Mosquitto.installed().isEmpty()) {
            say("  Mosquitto is not installed");
            return;
        }
        say(SharedTable.head());
        Path folder = Files.createTempDirectory("majic-figures-broker");
        for (int[] row : rows) {
            List<ChildProgram.Lab> labs = new ArrayList<>();
            try (Mosquitto broker = Mosquitto.start(
                    folder,
                    Loopback.freePort(),
                    "allow_anonymous true",
                    "sys_interval 1",
                    "log_dest none",
                    "set_tcp_nodelay true")) {
                for (int left = row[1]; left > 0; left -= MOST_OF_A_LAB) {
                    labs.add(programs.usualLab(Math.min(left, MOST_OF_A_LAB)));
                }
                sharedLoad(broker, row[0], labs).forEach(Figures::say);
            } finally {
                labs.forEach(ChildProgram.Lab::close);
            }
        }
    }

    /**
     * Returns a row and the kinds of threads of the desks; one sentence instead if the computer is too slow for a row.
     */
    private List<String> sharedLoad(Mosquitto broker, int desks, List<ChildProgram.Lab> labs) throws IOException {
        List<String> arguments =
                new ArrayList<>(List.of("mqtt://127.0.0.1:" + broker.port() + "/lab", "" + broker.pid(), "" + desks));
        arguments.add(labs.stream().map(lab -> "" + lab.pid()).collect(Collectors.joining(",")));
        labs.forEach(lab -> arguments.addAll(lab.pioneers()));
        List<String> lines = programs.lines(SharedLoad.class, arguments);
        return lines.size() < 2
                ? List.of("  no row for " + desks + " desks: " + (lines.isEmpty() ? "they have ended" : lines.get(0)))
                : List.of(SharedTable.row(lines.get(0)), "        " + lines.get(1));
    }

    private void crash() throws IOException, InterruptedException {
        say("kill -9 during a session, while its robots drive (no setting and no line within a file may be lost)");
        Crashes.measure().forEach(line -> say("  " + line));
    }

    private void mapping() throws IOException {
        say("a map from a public log (at most 60 s of processor time)");
        new MappingFigures().mapping().forEach(line -> say("  %s", line));
        say("a map of an office of the lab, built while the robot drives past another one");
        programs.linesOfBuild(OfficeFigures.class, List.of()).forEach(line -> say("  %s", line));
    }

    private void localisation() throws IOException {
        say("localisation in the second half of a public log, on the map of its first half");
        new MappingFigures().localisation().forEach(line -> say("  %s", line));
        say("localisation in an office of the lab, by sonars alone (95 of 100 within 500 mm) and by a laser");
        say("  | noise | model | median / 95 of 100 / largest | of the heading | place unknown |");
        programs.linesOfBuild(OfficeFigures.class, List.of("localisation", "1", "2", "3", "7"))
                .forEach(line -> say("  %s", line));
    }

    private void goTo() throws IOException {
        say("goals in an office of the lab: reached (99 of 100; Aibo and Hemisson 95), contacts (0), length of the way"
                + " (1.1; 95 of 100 within 1.3), time (1.4), error (50 mm and 5 deg)");
        for (String kind : List.of("laser", "sonar", "ros", "aibo", "hemisson")) {
            programs.linesOfBuild(GoToFigures.class, List.of(kind, "100", "1")).forEach(line -> say("  %s", line));
        }
        say(
                "a new obstacle in front of a robot under way, ms: from the first report that shows it to the first bytes of a"
                        + " lower speed (100), the processor time of the decision; contacts");
        for (String kind : List.of("laser", "sonar", "ros")) {
            programs.linesOfBuild(ReactionFigures.class, List.of(kind, "50", "1"))
                    .forEach(line -> say("  %s", line));
        }
        say("many robots with random goals in the same office: contacts (0)");
        programs.linesOfBuild(TrafficFigures.class, List.of("20", "3600", "1")).forEach(line -> say("  %s", line));
    }

    private void mavlink() throws IOException {
        say("20 vehicles that send to one UDP port: from STOP to its bytes (99 of 100 at most 20 ms)");
        programs.linesOfBuild(MavlinkFigures.class, List.of("stop")).forEach(line -> say("  %s", line));
        say("motions of the simulated rover with the usual noise, by its true place");
        programs.linesOfBuild(MavlinkFigures.class, List.of("motion")).forEach(line -> say("  %s", line));
        say("a team without a window whose robots report ten times a second");
        try (ChildProgram.Lab lab = programs.mavlinkLab(NINE_PIONEERS)) {
            programs.linesOfBuild(MavlinkFigures.class, lab.addresses()).forEach(line -> say("  %s", line));
        }
        try (ChildProgram.Lab lab = programs.usualLab(NINE_PIONEERS)) {
            programs.linesOfBuild(MavlinkFigures.class, lab.pioneers()).forEach(line -> say("  %s", line));
        }
    }

    private void ros() throws IOException, InterruptedException {
        try (ChildProgram.Lab lab = programs.rosLab()) {
            ros(lab.addresses().get(0));
        }
    }

    private void ros(String address) throws IOException, InterruptedException {
        if (!address.startsWith("ros://")) {
            throw new IllegalArgumentException("no figure " + address);
        }
        say("a robot behind a rosbridge server, driven by MAJIC and then by roslibpy with the same subscriptions");
        new RosFigures(programs, address).measure().forEach(line -> say("  " + line));
    }

    /** Counts classes and calls, and the classes with one user. */
    private void ways() throws IOException {
        say("classes and calls of majic, from parseText to the first byte on the link or the answer,");
        say("and from the bytes of a report to a listener (median)");
        for (List<String> robot : List.of(List.of("pioneer", "sonar"), List.of("aibo", "distanceNear"))) {
            programs.linesOfBuild(Ways.class, robot).forEach(line -> say("  " + line));
        }
        say(OneUserClasses.measure() + " (at most 27 %)");
    }

    private static void add(Map<String, List<Double>> seconds, String name, double value) {
        seconds.computeIfAbsent(name, key -> new ArrayList<>()).add(value);
    }

    private static double median(Map<String, List<Double>> seconds, String name) {
        List<Double> sorted = new ArrayList<>(seconds.getOrDefault(name, List.of()));
        Collections.sort(sorted);
        return sorted.get(sorted.size() / 2);
    }

    private static void say(String format, Object... values) {
        System.out.println(values.length == 0 ? format : String.format(Locale.ROOT, format, values));
    }
}
