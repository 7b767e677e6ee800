package majic.pioneer.session;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.LinkLost;
import majic.bot.MotionStopped;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.LaserChunk;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.arcos.PioneerIdentity;
import majic.pioneer.arcos.Report;
import majic.pioneer.arcos.Sip;
import majic.pioneer.state.Equipment;
import majic.pioneer.state.LaserScans;
import majic.pioneer.state.Limits;
import majic.pioneer.state.Model;
import majic.pioneer.state.Models;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.Ramps;
import majic.pioneer.state.Sonars;
import majic.pioneer.state.StateTracker;
import majic.time.TimeSource;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * One session with a robot, from the opening of the connection to its closing. Reports are handled on the thread of the
 * connection; everything else may be called from any thread.
 */
public final class PioneerSession implements PioneerConnection.Listener {
    /** All sonars have fired by then, seconds from the first SIP. */
    private static final double SONAR_ROUND_S = 1;

    /** Time for the robot to act on the last commands, seconds. */
    private static final double CLOSING_S = 0.1;

    private final PioneerConnection connection;
    private final RobotLine line;
    private final ConnectWait wait;
    private final TimeSource time;
    private final Listener listener;
    private final Function<String, Model> models;
    private final RoundTrip roundTrip;
    private final WheelMotors motors;
    private final LinkWatch watch;
    private final Subscriptions subscriptions;
    private final SessionLaser laser;
    private final Pose start;
    private final AtomicBoolean lost = new AtomicBoolean();
    private volatile Model model = Models.USUAL;
    private volatile StateTracker tracker = new StateTracker(Models.USUAL, Pose.START);
    private volatile LaserScans laserScans = new LaserScans(Models.USUAL);
    private volatile Equipment equipment = Equipment.of(Models.USUAL, null);
    private volatile Optional<Sonars> sonars = Optional.empty();
    private volatile Ramps ramps = Ramps.careful(equipment.limits());
    private volatile @Nullable PioneerIdentity identity;
    private volatile @Nullable Config config;
    private volatile long openedNanos;

    /** Is notified of what happens in a session. */
    public interface Listener {
        /** A new state, on the thread of the connection. */
        void stateReported(PioneerSession session, PioneerState state);

        /** The first scan of the laser has come, on the thread of the connection: the robot has one. */
        void laserFound(PioneerSession session);

        /** A scan of the laser, on the thread of the connection. */
        void scanned(PioneerSession session, RangeScan scan);

        /** Another report, on the thread of the connection: parameters may have changed. */
        void otherReported();

        /** The session has ended; called once, and not before the robot is identified. */
        void lost(PioneerSession session, LinkLost cause);

        /** A message for the user. */
        void notice(String message);
    }

    /**
     * Creates a session; opens nothing.
     *
     * @param wait of the thread that connects
     * @param start the pose that the odometry begins with
     * @param models finds a model by its subclass
     */
    public PioneerSession(
            PioneerConnection connection,
            ConnectWait wait,
            Pose start,
            Function<String, Model> models,
            Listener listener) {
        this.connection = connection;
        this.line = connection.line();
        this.wait = wait;
        this.time = wait.waiting().time();
        this.start = start;
        this.models = models;
        this.listener = listener;
        this.roundTrip = new RoundTrip(line, wait.waiting());
        this.motors = new WheelMotors(line, this::state, this::equipment, time, listener::notice);
        this.watch = new LinkWatch(line, motors, time, wait.waiting().changes());
        this.subscriptions = new Subscriptions(line, time);
        this.laser = new SessionLaser(line, time);
    }

    /**
     * Connects and begins the session, without moving anything or switching motors on. Leaves nothing open when it
     * throws.
     *
     * @param requested the ramps that a user has set; null for the careful ones. Reduced to the robot's limits, then
     *     sent
     * @throws BotException if there is no Pioneer, or it sends no SIP
     */
    public void open(@Nullable Ramps requested) {
        try {
            connection.open(this);
            use(requested);
            subscriptions.begin(config);
            laser.begin(config);
            startSonar();
        } catch (RuntimeException e) {
            close();
            throw e;
        }
    }

    /**
     * Switches the sonars on if they are not on from OPEN. The vendor's simulator sends no readings in the SIP after
     * this command (ARCOS sheet 8.2).
     */
    private void startSonar() {
        openedNanos = time.nanos();
        PioneerState now = state();
        boolean on = now.sonarOn() && equipment.sonarArrays().stream().allMatch(now::sonarOn);
        if (!on) {
            line.send(ArcosCommand.SONAR.packet(1));
        }
        if (line.hasEnded()) {
            throw new ConnectFailed(
                    Reason.BUSY, connection.address() + " closed the connection right after the handshake");
        }
    }

    /**
     * Waits for the first readings of sonars, which come in the first second of a session; later, and on a thread that
     * must not wait, does nothing.
     *
     * @param come whether they have come
     */
    public void awaitFirstReadings(Predicate<PioneerState> come) {
        double leftS = SONAR_ROUND_S - time.secondsSince(openedNanos);
        if (leftS > 0) {
            await(come, leftS);
        }
    }

    @Override
    public void identified(PioneerIdentity known) {
        Model found = models.apply(known.subclass());
        model = connection.scales() ? found.scaledByLibrary() : found;
        equip(Equipment.of(model, null));
        tracker = new StateTracker(model, start);
        laserScans = new LaserScans(model);
        identity = known;
    }

    private void equip(Equipment found) {
        equipment = found;
        sonars = Sonars.of(found.model());
    }

    @Override
    public void configured(Config reportedConfig) {
        equip(Equipment.of(model, reportedConfig));
        config = reportedConfig;
        tracker.use(equipment.model());
        roundTrip.answered();
        listener.otherReported();
    }

    @Override
    public void reported(Report report) {
        if (identity == null) {
            return;
        }
        tracker.add(report);
        // Last: a thread that waits for a fresh report reads the state next.
        subscriptions.received(report);
        listener.otherReported();
    }

    @Override
    public void reported(LaserChunk chunk) {
        PioneerState now = tracker.last();
        if (now != null) {
            laserScans.add(chunk, now).ifPresent(this::scanned);
        }
    }

    @Override
    public void reported(RangeScan scan) {
        PioneerState now = tracker.last();
        if (now != null) {
            scanned(scan.at(now.pose().plus(scan.odometry())));
        }
    }

    @Override
    public void notice(String message) {
        listener.notice(message);
    }

    private void scanned(RangeScan scan) {
        boolean found = !laser.isThere();
        laser.received(scan);
        if (found) {
            listener.laserFound(this);
        }
        listener.scanned(this, scan);
    }

    @Override
    public void reported(Sip sip) {
        if (identity == null) {
            return;
        }
        PioneerState now = tracker.track(sip, time.nanos());
        motors.reported(now);
        listener.stateReported(this, now);
    }

    @Override
    public void ended(LinkLost cause) {
        if (identity != null && !lost.getAndSet(true)) {
            listener.lost(this, cause);
        }
    }

    /**
     * Monitors the connection.
     *
     * @return when to call this again, seconds; the first time is {@link LinkWatch#PERIOD_S} after connecting
     */
    public double checkLink() {
        PioneerState now = tracker.last();
        if (now == null || line.hasEnded()) {
            return LinkWatch.PERIOD_S;
        }
        LinkLost cause = watch.check(now);
        if (cause != null) {
            line.abort(cause);
            ended(cause);
        }
        return watch.againS(now);
    }

    /**
     * Requests reports that are due, unless the robot has stopped reporting: it would resume its motion at the request.
     * To be called every {@link Subscriptions#PERIOD_S} or more often.
     *
     * @param scans whether something asks for scans
     */
    public void requestReports(boolean scans) {
        PioneerState now = tracker.last();
        if (now != null && !motors.isHeld() && time.secondsSince(now.atNanos()) < Subscriptions.SPEAKING_S) {
            subscriptions.requestDue();
            laser.requestDue(scans);
        }
    }

    /**
     * Stops the robot, switches its motors off, ends its session and the connection; takes little over a second at
     * most.
     */
    public void close() {
        if (identity != null) {
            line.sendIfPossible(
                    ArcosCommand.STOP.packet(),
                    ArcosCommand.VEL.packet(0),
                    ArcosCommand.RVEL.packet(0),
                    ArcosCommand.ENABLE.packet(0));
            wait.waiting().awaitClosing(line::hasEnded, CLOSING_S);
        }
        connection.close();
    }

    /** Whether the robot has reported a state in this session. */
    public boolean hasReported() {
        return tracker.last() != null;
    }

    /**
     * Sends commands.
     *
     * @throws LinkLost if the connection has ended or a command takes longer than 1 s
     */
    public void send(Packet... commands) {
        line.send(commands);
    }

    /**
     * Sends ramps, which hold for this session.
     *
     * @param requested reduced to the robot's limits where necessary; null for the careful ones
     */
    public void use(@Nullable Ramps requested) {
        Limits limits = equipment.limits();
        ramps = requested == null ? Ramps.careful(limits) : requested.within(limits);
        line.send(ramps.packets());
    }

    /** The ramps that were last sent; the careful ones before. */
    public Ramps ramps() {
        return ramps;
    }

    public Subscriptions subscriptions() {
        return subscriptions;
    }

    public WheelMotors motors() {
        return motors;
    }

    /** Why a value is unknown that does not come over the connection, as half a sentence. */
    public String missing() {
        return connection.missing();
    }

    /** Counts of packets and damaged bytes; null if the connection does not know them. */
    public @Nullable PacketCounts packetCounts() {
        return connection.counts();
    }

    /** The robot's model and equipment; of a usual model before it is identified. */
    public Equipment equipment() {
        return equipment;
    }

    /** The robot's sonars; empty if it has none, or is not identified yet. */
    public Optional<Sonars> sonars() {
        return sonars;
    }

    public SessionLaser laser() {
        return laser;
    }

    /**
     * The robot's range sensors. Right after connecting to a simulator, the first scan of its laser is awaited, if the
     * thread may wait.
     */
    public List<RangeSensor> rangeSensors() {
        double leftS = laser.undecidedS();
        if (leftS > 0) {
            await(state -> laser.isThere(), leftS);
        }
        return Stream.of(sonars.map(Sonars::sensor), laser.sensor())
                .flatMap(Optional::stream)
                .toList();
    }

    /** The robot's names; null before it is identified. */
    public @Nullable PioneerIdentity identity() {
        return identity;
    }

    /** Null until it has come; not every robot sends it. */
    public @Nullable Config config() {
        return config;
    }

    /**
     * The last state that the robot reported.
     *
     * @throws BotException before the first one; a session that has been opened has one
     */
    public PioneerState state() {
        PioneerState now = tracker.last();
        if (now == null) {
            throw new BotException("no reading yet");
        }
        return now;
    }

    /**
     * Waits until the reported state meets a condition, or the line ends. A thread that must not wait only tests the
     * last state.
     *
     * @param seconds the longest wait
     * @return whether the last state meets it
     * @throws MotionStopped if the thread is interrupted meanwhile
     */
    public boolean await(Predicate<PioneerState> condition, double seconds) {
        BooleanSupplier met = () -> {
            PioneerState now = tracker.last();
            return now != null && condition.test(now);
        };
        wait.waiting().await(() -> line.hasEnded() || met.getAsBoolean(), WaitPolicy.isAllowed() ? seconds : 0);
        return met.getAsBoolean();
    }

    /**
     * Waits for a SIP, newer than the last, that shows the robot stationary.
     *
     * @param seconds the longest wait
     * @return whether one came in time
     * @throws LinkLost if the line ended before: whether the robot is stationary is not known
     * @throws MotionStopped if the thread is interrupted meanwhile
     */
    boolean awaitStationary(double seconds) {
        PioneerState before = tracker.last();
        Sip old = before == null ? null : before.sip();
        boolean stationary = await(now -> now.sip() != old && !now.isMoving(), seconds);
        LinkLost end = line.end();
        if (!stationary && end != null) {
            throw new LinkLost(end.getMessage(), end);
        }
        return stationary;
    }

    /**
     * Waits for a SIP that shows the robot stationary, and that it sent after it had received the stop. A robot that
     * does not answer CONFIG, or a library that keeps the answers, cannot tell the latter; the next SIP decides then.
     *
     * @param seconds the longest wait
     * @return whether one came in time
     * @throws LinkLost if the line ended before
     * @throws MotionStopped if the thread is interrupted meanwhile
     */
    public boolean awaitStopped(double seconds) {
        long beganNanos = time.nanos();
        boolean received = config == null || !line.passesAnswers() || roundTrip.await(seconds);
        return awaitStationary(received ? seconds - time.secondsSince(beganNanos) : 0);
    }
}
