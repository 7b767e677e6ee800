package majic.soak;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.log.SessionListener;
import majic.script.MajicParser;
import majic.script.Session;
import majic.team.Member;
import majic.time.Signal;
import majic.time.TimeSource;
import majicsim.net.Faults;

/**
 * One lab and one team: three sources send lines at the same time, a prompt, a pipe and a socket, while each robot's
 * connection fails again and again. No robot may move after it has confirmed a STOP. Afterwards all faults end, and
 * each robot must obey again. For one use.
 */
final class SoakRound {
    /** How long everything that was sent may take to end, seconds of the lab. */
    private static final double END_BOUND_S = 900;

    /** How long a robot may take to be connected again once there are no faults, seconds of the lab. */
    private static final double RETURN_BOUND_S = 120;

    private static final int FEWEST_FAULTS = 2;
    private static final double CHECK_S = 0.1;

    private final long seed;
    private final int linesPerSource;
    private final AtomicLong progress;
    private final ConcurrentLinkedQueue<SentLine> sent = new ConcurrentLinkedQueue<>();
    private final Map<FaultScript.Kind, Long> faults =
            Collections.synchronizedMap(new EnumMap<>(FaultScript.Kind.class));
    private final List<String> problems = Collections.synchronizedList(new ArrayList<>());
    private final AtomicInteger running = new AtomicInteger();
    private final AtomicInteger disturbed = new AtomicInteger();
    private volatile boolean over;

    /**
     * Creates a round that sends about this many lines.
     *
     * @param progress counts the lines of the session, commands and answers
     */
    SoakRound(long seed, int lines, AtomicLong progress) {
        this.seed = seed;
        this.progress = progress;
        this.linesPerSource = lines / Source.values().length;
    }

    /** A place where lines come from. */
    private enum Source {
        PROMPT(MajicParser::prompt),
        PIPE(MajicParser::pipe),
        SOCKET(MajicParser::socket);

        private final Function<Session, MajicParser> maker;

        Source(Function<Session, MajicParser> maker) {
            this.maker = maker;
        }

        MajicParser parser(Session session) {
            return maker.apply(session);
        }
    }

    /**
     * What a round found.
     *
     * @param outcomes commands to a robot by how they ended
     * @param faults how many were ordered
     * @param problems what must not be, as sentences
     * @param labSeconds how long it took by the lab's clock
     * @param log the session log
     */
    record Result(
            Map<Outcome, Long> outcomes,
            Map<FaultScript.Kind, Long> faults,
            List<String> problems,
            double labSeconds,
            Path log) {}

    /** Runs it with the files in a folder. */
    Result run(Path folder) throws IOException, InterruptedException {
        Path log;
        double seconds;
        int robots;
        try (SoakLab soak = new SoakLab(seed, folder)) {
            log = soak.log();
            robots = soak.robots().size();
            SessionListener counter = line -> progress.incrementAndGet();
            soak.session().addListener(counter);
            send(soak);
            soak.session().removeListener(counter);
            seconds = soak.lab().time().nanos() / 1e9;
        }
        Account account = new Account(List.copyOf(sent), robots).read(log);
        problems.addAll(account.problems());
        return new Result(account.outcomes(), faults, List.copyOf(problems), seconds, log);
    }

    private void send(SoakLab soak) throws InterruptedException {
        Signal changes = soak.team().changes();
        for (int robot = 1; robot <= soak.robots().size(); robot++) {
            disturb(soak, robot);
        }
        StopCheck check = new StopCheck(soak.lab(), soak.team(), problems::add);
        start(soak, "stop check", disturbed, () -> {
            while (!over) {
                soak.lab().time().sleep(CHECK_S);
                check.look();
            }
        });
        List<MajicParser> parsers = new ArrayList<>();
        for (Source source : Source.values()) {
            parsers.add(send(soak, source));
        }
        changes.await(() -> running.get() == 0, Signal.FOR_EVER);
        over = true;
        changes.await(() -> disturbed.get() == 0, Signal.FOR_EVER);
        if (!changes.await(() -> parsers.stream().allMatch(MajicParser::isDone), END_BOUND_S)) {
            problems.add("some lines did not end within " + END_BOUND_S + " s");
        }
        afterwards(soak);
    }

    private void disturb(SoakLab soak, int robot) {
        Faults lines = soak.lab().simulators().faults(soak.robots().get(robot - 1));
        FaultScript script = new FaultScript(seed, robot);
        start(soak, "faults of robot " + robot, disturbed, () -> {
            TimeSource time = soak.lab().time();
            for (int count = 0; count < FEWEST_FAULTS || !over; count++) {
                faults.merge(script.next(lines), 1L, Long::sum);
                time.sleep(script.faultSeconds());
                lines.none();
                switchOnAgainIfDeaf(soak);
                time.sleep(script.goodSeconds());
            }
        });
    }

    /**
     * Does what the driver's message asks for. A garbled line deafens a Hemisson until it is switched off and on if it
     * fills the command buffer (Hemisson sheet 4.2) or begins to load a program (sheet 15).
     */
    private static void switchOnAgainIfDeaf(SoakLab soak) {
        soak.lab().simulators().besideHemisson(hemisson -> {
            if (!hemisson.takesCommands()) {
                hemisson.powerCycle();
            }
        });
    }

    private MajicParser send(SoakLab soak, Source source) {
        MajicParser parser = source.parser(soak.session());
        CommandScript script = new CommandScript(seed, soak.robots(), source.ordinal(), Source.values().length + 1);
        start(soak, "source " + source, running, () -> {
            for (int line = 0; line < linesPerSource; line++) {
                send(parser, script.next());
                soak.lab().time().sleep(script.pauseSeconds());
                parser.awaitRoom();
            }
        });
        return parser;
    }

    /** What a thread of the round does. */
    @FunctionalInterface
    private interface Work {
        void run() throws InterruptedException;
    }

    private static void start(SoakLab soak, String name, AtomicInteger count, Work work) {
        count.incrementAndGet();
        soak.lab().time().runAsync(name, () -> {
            try {
                work.run();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            } finally {
                count.decrementAndGet();
                soak.team().changes().raise();
            }
        });
    }

    private void send(MajicParser parser, SentLine line) {
        sent.add(line);
        parser.parseLine(line.number(), line.text());
    }

    /** Nothing may be left behind by a fault: each robot is connected again, and does what it is sent. */
    private void afterwards(SoakLab soak) throws InterruptedException {
        MajicParser parser = MajicParser.pipe(soak.session());
        CommandScript script =
                new CommandScript(seed, soak.robots(), Source.values().length, Source.values().length + 1);
        for (int robot = 1; robot <= soak.robots().size(); robot++) {
            int number = robot;
            if (soak.team().members().stream().noneMatch(member -> member.number() == number)) {
                send(parser, script.adding(robot));
                parser.awaitAll();
            }
        }
        send(parser, script.release());
        soak.team().changes().await(() -> soak.team().members().stream().allMatch(SoakRound::isReady), RETURN_BOUND_S);
        for (Member member : soak.team().members()) {
            if (!isReady(member)) {
                problems.add(notReady(soak, member));
            }
            send(parser, script.check(member.number()));
        }
        if (!parser.awaitAll()) {
            problems.add("a robot does not obey after the last fault");
        }
    }

    /** Connects a robot that is still lost, so that the reason is known; an attempt that has begun ends before that. */
    private static String notReady(SoakLab soak, Member member) throws InterruptedException {
        String state = "robot " + member.number() + " is not ready " + RETURN_BOUND_S + " s after the last fault: "
                + member.bot().connection() + ", owner " + member.owner() + ", reconnecting "
                + soak.reconnecting(member);
        soak.team().changes().await(() -> member.bot().connection() != MajicBot.Connection.CONNECTING, RETURN_BOUND_S);
        try {
            member.bot().connect();
            return state + "; it can be connected now";
        } catch (BotException e) {
            return state + "; " + e.getMessage();
        }
    }

    private static boolean isReady(Member member) {
        return member.bot().isConnected() && member.isIdle() && member.owner() == null;
    }
}
