package majic.recorder;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.log.Line;
import majic.log.SessionListener;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.StopStatus;
import majic.team.Team;
import majic.team.TeamListener;
import majic.text.LateLogger;
import majic.time.Signal;
import majic.time.TimeSource;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * Records what the robots of a team report, what happens to them, and the lines of the session, from now until it is
 * closed. Uses two threads: one finds what has changed, after each report of a robot and at most 10 times a second, the
 * other writes. So it delays neither a robot nor a listener. It sends the robots nothing, except that those with a
 * laser scanner are asked for their scans while they drive. Thread-safe.
 */
public final class Recorder implements SessionListener, AutoCloseable {
    private static final Logger LOG = LateLogger.of(Recorder.class);
    private static final double LEAST_PERIOD_S = 0.1;
    private static final double MOST_PERIOD_S = 1;
    private static final double PICTURE_PERIOD_S = 1;
    private static final long CLOSE_BOUND_MS = 1000;
    private static final int MOST_EARLY = 100_000;

    private final Team team;
    private final RoomSampler room;
    private final Function<MajicBot, List<Pose>> ways;
    private final TimeSource time;
    private final long startNanos;
    private final Instant begin = Instant.now();
    private final RecordingWriter writer;
    private final Signal due;
    private final EventLines events;
    private final TeamListener robotsOfTeam = new Joining();
    private final BotListener reports = new Reports();
    private final Map<MajicBot, RobotSampler> robots = new ConcurrentHashMap<>();
    private final Map<MajicBot, Double> pictures = new ConcurrentHashMap<>();
    private volatile @Nullable Thread sampling;
    private boolean failed;
    private final StringBuilder early = new StringBuilder();
    private volatile int part;
    private volatile boolean changed = true;
    private volatile boolean closed;

    /**
     * Creates a recorder; {@link #start()} starts it. Writes no file before there is a robot.
     *
     * @param team the robots to record
     * @param factory has the simulated lab
     * @param folder receives the files
     * @param alarm receives a sentence when nothing can be written, and when that is possible again; on any thread
     */
    public Recorder(Team team, BotFactory factory, RecordingFolder folder, Consumer<String> alarm) {
        this(team, factory, folder, alarm, robot -> List.of());
    }

    /**
     * Creates a recorder that records the ways of robots too.
     *
     * @param team the robots to record
     * @param factory has the simulated lab
     * @param folder receives the files
     * @param alarm receives a sentence when nothing can be written, and when that is possible again; on any thread
     * @param ways returns the way on which a robot drives to a place, in its own frame, the point where it is first;
     *     empty if it does not. Must return soon
     */
    public Recorder(
            Team team,
            BotFactory factory,
            RecordingFolder folder,
            Consumer<String> alarm,
            Function<MajicBot, List<Pose>> ways) {
        this.team = team;
        this.ways = ways;
        this.room = new RoomSampler(factory);
        this.time = team.time();
        this.startNanos = time.nanos();
        this.due = time.signal();
        this.writer = new RecordingWriter(folder, alarm, System::nanoTime);
        this.events = new EventLines(team, this::write);
    }

    /** Starts to record, also the robots that are in the team already. Called once. */
    public void start() {
        team.addListener(robotsOfTeam);
        team.addListener(events);
        team.addCommandListener(events);
        team.members().forEach(this::join);
        Thread started = time.thread("recorder", () -> WaitPolicy.observing(this::run));
        sampling = started;
        started.start();
    }

    /**
     * Returns what was recorded so far.
     *
     * @return reads the files at each call
     */
    public RecordedHistory history() {
        return new RunningHistory(writer::files, this::seconds);
    }

    /**
     * Returns the time of the recording.
     *
     * @return seconds since it began, on the clock of the team
     */
    public double seconds() {
        return seconds(time.nanos());
    }

    /**
     * Returns the time of the recording at a moment.
     *
     * @param nanos on the clock of the team
     * @return seconds since the recording began
     */
    public double seconds(long nanos) {
        return (nanos - startNanos) / 1e9;
    }

    /**
     * Returns how many pieces of the recording are missing because the disk was too slow.
     *
     * @return 0 normally
     */
    public long dropped() {
        return writer.dropped();
    }

    /** Records a line of the session. */
    @Override
    public void line(Line line) {
        write(RecordingFormat.line(line));
    }

    /**
     * Records what the robots have reported by now, and writes it, for one second at most. The robots are not affected.
     */
    @Override
    public void close() {
        team.removeListener(robotsOfTeam);
        team.removeListener(events);
        team.removeCommandListener(events);
        robots.keySet().forEach(bot -> bot.removeListener(reports));
        robots.values().forEach(RobotSampler::reported);
        closed = true;
        due.raise();
        awaitLastSample();
        robots.values().forEach(RobotSampler::end);
        writer.close();
    }

    private void awaitLastSample() {
        Thread started = sampling;
        try {
            if (started != null) {
                started.join(CLOSE_BOUND_MS);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void write(String lines) {
        String stamped = ValueText.time(seconds()) + lines;
        if (part == 0) {
            keep(stamped);
        } else if (!writer.write(stamped)) {
            robots.values().forEach(RobotSampler::forget);
        }
    }

    /** Keeps what happens before there is a robot, and so a file. */
    private void keep(String lines) {
        synchronized (early) {
            if (early.length() < MOST_EARLY) {
                early.append(lines);
            }
        }
    }

    private void join(Member member) {
        robots.computeIfAbsent(member.bot(), bot -> {
            bot.addListener(reports);
            return new RobotSampler(member, room.describe(member, seconds()), () -> ways.apply(bot));
        });
        wake();
    }

    private void wake() {
        if (!changed) {
            changed = true;
            due.raise();
        }
    }

    private void run() {
        try {
            while (!closed) {
                due.await(() -> closed || changed, MOST_PERIOD_S);
                changed = false;
                trySample();
                due.await(() -> closed, LEAST_PERIOD_S);
            }
            trySample();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** A driver that fails, perhaps of a plug-in, does not end the recording. */
    private void trySample() {
        try {
            sample();
        } catch (RuntimeException e) {
            LOG.log(failed ? Level.DEBUG : Level.WARNING, "the robots could not be recorded", e);
            failed = true;
        }
    }

    private void sample() {
        if (writer.needsPart()) {
            beginPart();
        }
        StringBuilder lines = new StringBuilder();
        StopStatus stops = team.stopStatus();
        for (Member member : team.members()) {
            RobotSampler robot = robots.get(member.bot());
            if (robot != null) {
                robot.sample(lines, stops, seconds());
            }
        }
        room.sample(lines, seconds());
        if (!lines.isEmpty()) {
            write(lines.toString());
        }
    }

    /** Begins a file; it contains what is known of every robot, so that it can be read without the files before it. */
    private void beginPart() {
        if (robots.isEmpty()) {
            return;
        }
        StringBuilder lines = new StringBuilder();
        room.describe(lines);
        robots.values().forEach(RobotSampler::forget);
        synchronized (early) {
            double beginS = early.isEmpty() ? seconds() : 0;
            if (writer.begin(new RecordingHead(begin, part + 1, beginS), lines.toString() + early)) {
                part++;
                early.setLength(0);
            }
        }
    }

    /** What the robots report. */
    private final class Reports implements BotListener {
        @Override
        public void stateChanged(MajicBot bot, BotState state) {
            reported(bot);
        }

        @Override
        public void connectionChanged(MajicBot bot, MajicBot.Connection connection) {
            reported(bot);
        }

        private void reported(MajicBot bot) {
            RobotSampler robot = robots.get(bot);
            if (robot != null) {
                robot.reported();
                wake();
            }
        }

        @Override
        public void pictureTaken(MajicBot bot, Supplier<byte[]> jpeg) {
            double now = seconds();
            if (now - pictures.getOrDefault(bot, Double.NEGATIVE_INFINITY) >= PICTURE_PERIOD_S) {
                pictures.put(bot, now);
                Member.of(bot).ifPresent(member -> write(RecordingFormat.picture(member.number(), jpeg.get())));
            }
        }
    }

    /** Samples the robots that are in the team. */
    private final class Joining implements TeamListener {
        @Override
        public void added(Member member) {
            join(member);
        }

        @Override
        public void removed(Member member) {
            RobotSampler removed = robots.remove(member.bot());
            if (removed != null) {
                removed.end();
            }
            pictures.remove(member.bot());
            member.bot().removeListener(reports);
        }
    }
}
