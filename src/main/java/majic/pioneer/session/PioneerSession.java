package majic.pioneer.session;

import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.Pose;
import majic.driver.RobotWait;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.arcos.PioneerIdentity;
import majic.pioneer.arcos.Report;
import majic.pioneer.arcos.ReportDecoder;
import majic.pioneer.arcos.Sip;
import majic.pioneer.state.Equipment;
import majic.pioneer.state.Limits;
import majic.pioneer.state.Models;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.Ramps;
import majic.pioneer.state.Reports;
import majic.pioneer.state.StateTracker;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * One session with a robot, from the opening of the link to its closing. Packets are handled on the reader thread of the line;
 * everything else may be called from any thread.
 */
public final class PioneerSession implements ArcosLine.Listener {
    private final ArcosLine line;
    private final ReportedState reported;
    private final WheelMotors motors;
    private final LinkWatch watch;
    private final ContinuousDrive driving;
    private final Subscriptions subscriptions;
    private final ConnectWait connecting;
    private final PacketInbox inbox;
    private final Autobaud autobaud;
    private final TimeSource time;
    private final Signal changes;
    private final Listener listener;
    private volatile Equipment equipment = Equipment.of(Models.USUAL, null);
    private volatile Ramps ramps = Ramps.careful(equipment.limits());
    private volatile @Nullable PioneerIdentity identity;
    private volatile @Nullable Config config;
    private volatile @Nullable StateTracker tracker;

    /** Is notified of what happens in a session. */
    public interface Listener {
        /** A new state, on the reader thread. */
        void stateReported(PioneerSession session, PioneerState state);

        /** Another report, on the reader thread: parameters may have changed. */
        void otherReported();

        /** The session has ended; not called before the handshake is done. */
        void lost(PioneerSession session, LinkLost cause);

        /** A message for the user. */
        void notice(String message);

        /** Whether the connection attempt is canceled. */
        boolean isCanceled();
    }

    public PioneerSession(ArcosLine line, TimeSource time, Signal changes, Listener listener) {
        this.line = line;
        RobotWait waiting = new RobotWait(time, changes);
        this.reported = new ReportedState(line, waiting);
        this.motors = new WheelMotors(line, reported, time, listener::notice);
        this.time = time;
        this.changes = changes;
        this.listener = listener;
        this.watch = new LinkWatch(line, motors, time, changes);
        this.driving = new ContinuousDrive(motors, reported, this::equipment, time, listener::notice);
        this.subscriptions = new Subscriptions(line, time);
        this.connecting = new ConnectWait(waiting, listener::isCanceled);
        this.inbox = new PacketInbox(connecting);
        this.autobaud = new Autobaud(line, reported);
    }

    /**
     * Opens the line and begins the session. Leaves nothing open when it throws.
     *
     * @param start the pose that the odometry begins with
     * @param ramps those that a user has set; null for the careful ones. Reduced to the robot's limits, then sent
     * @throws ArcosHandshake.SessionClosed if a second attempt will succeed
     * @throws BotException if there is no Pioneer
     */
    public void open(Pose start, @Nullable Ramps ramps) {
        new SessionOpening(this, line, inbox, connecting, time).run(start, ramps);
    }

    /** Ends the handshake: packets from now on are SIPs and reports. */
    void begin(PioneerIdentity known, Pose start) {
        identity = known;
        equipment = Equipment.of(Models.of(known.subclass()), null);
        tracker = new StateTracker(equipment.model(), start);
    }

    boolean hasBegun() {
        return tracker != null;
    }

    @Override
    public void received(Packet packet) {
        if (!hasBegun()) {
            inbox.put(packet);
        } else if (packet.isSip()) {
            receive(Sip.decode(packet));
        } else if (packet.type() == Config.TYPE) {
            configure(Config.decode(packet));
            listener.otherReported();
        } else if (packet.isReset()) {
            end(new LinkLost("connection lost: the robot's controller was reset"));
        } else {
            receive(ReportDecoder.decode(packet));
        }
    }

    private void configure(Config reportedConfig) {
        equipment = Equipment.of(equipment.model(), reportedConfig);
        config = reportedConfig;
    }

    private void receive(@Nullable Report report) {
        StateTracker tracking = tracker;
        if (report != null && tracking != null) {
            Reports reports = tracking.add(report);
            PioneerState now = reported.last();
            if (now != null) {
                reported.set(now.with(reports));
            }
            // Last: a thread that waits for a fresh report reads the state next.
            subscriptions.received(report);
            listener.otherReported();
        }
    }

    private void receive(@Nullable Sip sip) {
        StateTracker tracking = tracker;
        if (sip != null && tracking != null) {
            PioneerState now = tracking.track(sip, time.nanos());
            reported.set(now);
            if (!now.isMoving()) {
                motors.release();
            }
            driving.check(now);
            listener.stateReported(this, now);
        }
    }

    @Override
    public void ended(LinkLost cause) {
        inbox.end(cause);
        if (hasBegun()) {
            listener.lost(this, cause);
        }
    }

    /** Monitors the link; to be called every {@link LinkWatch#PERIOD_S}. */
    public void checkLink() {
        PioneerState now = reported.last();
        if (now != null && !line.hasEnded()) {
            LinkLost cause = watch.check(now);
            if (cause != null) {
                end(cause);
            }
        }
    }

    /** Requests reports that are due, unless the robot has stopped reporting: it would resume its motion at the request. */
    public void requestReports() {
        PioneerState now = reported.last();
        if (now != null && !motors.isHeld() && time.secondsSince(now.atNanos()) < Subscriptions.SPEAKING_S) {
            subscriptions.requestDue();
        }
    }

    private void end(LinkLost cause) {
        line.abort(cause);
        listener.lost(this, cause);
    }

    /** Stops the robot, switches its motors off, closes its session and the link; takes little over a second at most. */
    public void close() {
        if (hasBegun()) {
            new SessionClosing(line, autobaud, new RobotWait(time, changes)).run();
        }
        line.close();
    }

    public boolean hasReported() {
        return reported.isKnown();
    }

    /**
     * Sends packets, each in a write of its own.
     *
     * @throws LinkLost if the line has ended or a write takes longer than 1 s
     */
    public void send(Packet... packets) {
        line.send(packets);
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

    Autobaud autobaud() {
        return autobaud;
    }

    public Subscriptions subscriptions() {
        return subscriptions;
    }

    public WheelMotors motors() {
        return motors;
    }

    public ContinuousDrive driving() {
        return driving;
    }

    /** Counts of packets and damaged bytes. */
    public PacketCounts packetCounts() {
        return line.counts();
    }

    /** The robot's model and equipment; of a usual model during the handshake. */
    public Equipment equipment() {
        return equipment;
    }

    /** The robot's names; null during the handshake. */
    public @Nullable PioneerIdentity identity() {
        return identity;
    }

    /** Null until it has come; not every robot sends it. */
    public @Nullable Config config() {
        return config;
    }

    /** The last state that the robot reported. */
    public PioneerState state() {
        return reported.get();
    }

    /** Waits for states. */
    public ReportedState reported() {
        return reported;
    }
}
