package majic.figures.ways;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.Semaphore;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import majic.act.NoActs;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.environment.Settings;
import majic.figures.Measurement;
import majic.figures.ways.CallRecord.Call;
import majic.log.Line;
import majic.log.SessionLog;
import majic.script.MajicParser;
import majic.script.Session;
import majic.simulation.SimulatedLab;
import majic.team.Answer;
import majic.team.BotFactory;
import majic.team.Team;
import majic.team.TeamListener;
import majicsim.LabOptions;
import net.bytebuddy.agent.ByteBuddyAgent;

/**
 * A program that counts the classes and the calls of {@code majic} between a cause and its effect: from
 * {@code parseText} to the first byte on the link, or to the answer where nothing is sent, and from the bytes of a
 * report to a listener. It commands one robot of the simulated lab, as a prompt does. Only the threads on that way
 * count: the one that submits the line, the worker or the stop of the robot, the readers of the links, and the one that
 * calls the listeners. Nested classes and lambda expressions count as parts of the class around them.
 */
public final class Ways implements TeamListener, BotListener {
    private static final int ROUNDS = 4;
    private static final int REPORTS_MS = 4000;
    private static final int AT_REST_MS = 300;
    private static final String ANSWERED = "answered";
    private static final String REPORTED = "reported";
    private static final Set<Line.Kind> TROUBLE = Set.of(Line.Kind.ERROR, Line.Kind.FAILURE, Line.Kind.ALARM);

    private final Semaphore answers = new Semaphore(0);
    private final MajicParser parser;
    private final boolean listing = Boolean.getBoolean("majic.ways");

    private Ways(Session session) {
        this.parser = MajicParser.prompt(session);
        session.addListener(line -> {
            if (TROUBLE.contains(line.kind())) {
                System.err.println(line.text());
            }
        });
    }

    /** The first argument is the robot of the lab, the second one of its parameters. */
    public static void main(String[] arguments) {
        CallRecord.install(ByteBuddyAgent.install());
        Measurement.run(() -> measure(arguments[0], arguments[1]));
    }

    private static List<String> measure(String robot, String parameter) throws Exception {
        try (SimulatedLab lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), 1);
                Team team = new Team(lab.time())) {
            BotFactory factory = new BotFactory(BotFactory.types(Ways.class.getClassLoader()), Settings.inMemory());
            factory.useLab(lab);
            MajicBot bot = factory.create("sim:" + robot);
            bot.connect();
            team.add(bot, OptionalInt.of(1));
            Ways ways = new Ways(new Session(team, factory, SessionLog.none(), NoActs.here(), () -> {}));
            team.addListener(ways);
            bot.addListener(ways);
            return ways.run(parameter).stream()
                    .map(line -> String.format("%-8s %s", robot, line))
                    .toList();
        }
    }

    private List<String> run(String parameter) throws InterruptedException {
        List<List<Call>> moves = new ArrayList<>();
        List<List<Call>> gets = new ArrayList<>();
        List<List<Call>> stops = new ArrayList<>();
        for (int round = 0; round < ROUNDS; round++) {
            moves.add(command("1 move 300", Call::isWrite));
            gets.add(command("1 get " + parameter, call -> call.isMark(ANSWERED)));
            stops.add(command("all stop", Call::isWrite));
            parser.parseText("release");
        }
        List<String> lines = new ArrayList<>();
        lines.add(line("1 move 300", moves));
        lines.add(line("all stop", stops));
        lines.add(line("1 get " + parameter, gets));
        lines.add(line("report", reports()));
        return lines;
    }

    /** Runs a line to its end and returns the calls from {@code parseText} to the first that ends the way. */
    private List<Call> command(String line, Predicate<Call> end) throws InterruptedException {
        Thread.sleep(AT_REST_MS);
        answers.drainPermits();
        CallRecord.take();
        parser.parseText(line).ifPresent(System.err::println);
        answers.acquire();
        List<Call> all = CallRecord.take().stream().filter(Ways::isOfCommand).toList();
        return all.stream().takeWhile(end.negate()).toList();
    }

    private static boolean isOfCommand(Call call) {
        return call.thread().equals("main")
                || call.thread().startsWith("robot ")
                || call.thread().startsWith("stopping robot");
    }

    /**
     * Returns the calls for each piece of bytes that led to a call of the listener, on the threads that read and that
     * call it. A piece begins with what its reader first calls outside of the link.
     */
    private static List<List<Call>> reports() throws InterruptedException {
        Thread.sleep(AT_REST_MS);
        CallRecord.take();
        Thread.sleep(REPORTS_MS);
        List<Call> all = CallRecord.take();
        Set<String> readers =
                all.stream().filter(Call::isRead).map(Call::thread).collect(Collectors.toSet());
        String listening = all.stream()
                .filter(call -> call.isMark(REPORTED))
                .map(Call::thread)
                .findFirst()
                .orElse("");
        List<List<Call>> pieces = new ArrayList<>(List.of(new ArrayList<>()));
        Set<String> waiting = new HashSet<>();
        for (Call call : all) {
            boolean reads = readers.contains(call.thread());
            if (call.isRead()) {
                waiting.add(call.thread());
            } else if (reads && !call.type().startsWith("majic.link.") && waiting.remove(call.thread())) {
                pieces.add(new ArrayList<>());
            }
            if (reads || call.thread().equals(listening)) {
                pieces.get(pieces.size() - 1).add(call);
            }
        }
        return pieces.stream()
                .filter(piece -> piece.stream().anyMatch(call -> call.isMark(REPORTED)))
                .toList();
    }

    /** Returns the way with the median of the calls; the first one loaded classes, and the last one is incomplete. */
    private String line(String what, List<List<Call>> ways) {
        List<List<Call>> sorted = ways.subList(1, Math.max(2, ways.size() - 1)).stream()
                .sorted(Comparator.comparingInt(List::size))
                .toList();
        List<Call> median = sorted.get(sorted.size() / 2).stream()
                .filter(call -> !call.type().isEmpty())
                .toList();
        if (listing) {
            System.out.println("== " + what);
            median.forEach(call -> System.out.println("   " + call));
        }
        Set<String> classes = new HashSet<>();
        median.forEach(call -> classes.add(call.type()));
        return String.format(
                Locale.ROOT,
                "%-20s %3d classes, %3d calls (%d to %d)",
                what,
                classes.size(),
                median.size(),
                sorted.get(0).size(),
                sorted.get(sorted.size() - 1).size());
    }

    @Override
    public void answered(Answer answer) {
        CallRecord.mark(ANSWERED);
        answers.release();
    }

    @Override
    public void stateChanged(MajicBot bot, BotState state) {
        CallRecord.mark(REPORTED);
    }
}
