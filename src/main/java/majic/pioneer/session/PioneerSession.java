package majic.pioneer.session;

import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.Pose;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.arcos.PioneerIdentity;
import majic.pioneer.arcos.Report;
import majic.pioneer.arcos.ReportDecoder;
import majic.pioneer.arcos.Sip;
import majic.pioneer.state.Bumpers;
import majic.pioneer.state.Model;
import majic.pioneer.state.Models;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.Ramps;
import majic.pioneer.state.Reports;
import majic.pioneer.state.StateTracker;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * One session with a robot, from the opened link to the closed one. Packets are handled on the line's reader thread;
 * everything else may be called from any thread.
 */
public final class PioneerSession implements ArcosLine.Listener {
    private final ArcosLine line;
    private final VelocitySetpoint velocity;
    private final ReportedState reported;
    private final LinkWatch watch;
    private final MotorPower motors;
    private final ContinuousDrive driving;
    private final Subscriptions subscriptions;
    private final ConnectWait connecting;
    private final PacketInbox inbox;
    private final Autobaud autobaud;
    private final TimeSource time;
    private final Signal changes;
    private final Owner owner;
    private volatile Model model = Models.USUAL;
    private volatile @Nullable PioneerIdentity identity;
    private volatile @Nullable Config config;
    private volatile @Nullable StateTracker tracker;

    /** Whose session it is. */
    public interface Owner {
        /** New readings, on the reader's thread. */
        void heard(PioneerSession session, PioneerState state);

        /** Something beside the readings, on the reader's thread: a parameter may read differently. */
        void heardMore();

        /** The session is over for good; not called before the handshake is done. */
        void lost(PioneerSession session, LinkLost cause);

        /** Something that a person should know. */
        void say(String message);

        /** Whether nobody wants the connection any more. */
        boolean hasGivenUp();
    }

    public PioneerSession(ArcosLine line, TimeSource time, Signal changes, Owner owner) {
        this.line = line;
        this.velocity = new VelocitySetpoint(line, time);
        this.reported = new ReportedState(line, changes);
        this.time = time;
        this.changes = changes;
        this.owner = owner;
        this.watch = new LinkWatch(line, velocity, time, changes);
        this.motors = new MotorPower(line, reported, time, owner::say);
        this.driving = new ContinuousDrive(velocity, reported, this::bumpers, motors, time, owner::say);
        this.subscriptions = new Subscriptions(line, time);
        this.connecting = new ConnectWait(changes, owner::hasGivenUp);
        this.inbox = new PacketInbox(connecting);
        this.autobaud = new Autobaud(line, reported);
    }

    /**
     * Opens the line and begins. Leaves nothing open when it throws.
     *
     * @param start where the robot is to be said to stand
     * @param dynamics fitted to the robot and then told to it
     * @throws ArcosHandshake.SessionClosed if a second try will do
     * @throws BotException if there is no such robot
     */
    public void open(Pose start, ActiveRamps dynamics) {
        new SessionOpening(this, line, inbox, connecting, time).run(start, dynamics);
    }

    /** The handshake is over; what comes from now on are SIPs. */
    void begin(PioneerIdentity known, Pose start) {
        identity = known;
        model = Models.of(known.subclass());
        tracker = new StateTracker(model, start);
    }

    boolean hasBegun() {
        return tracker != null;
    }

    @Override
    public void received(Packet packet) {
        if (!hasBegun()) {
            inbox.put(packet);
        } else if (packet.isSip()) {
            heard(Sip.decode(packet));
        } else if (packet.type() == Config.TYPE) {
            config = Config.decode(packet);
            owner.heardMore();
        } else if (packet.isReset()) {
            end(new LinkLost("connection lost: the robot's controller was reset"));
        } else {
            heard(ReportDecoder.decode(packet));
        }
    }

    private void heard(@Nullable Report report) {
        StateTracker tracking = tracker;
        if (report != null && tracking != null) {
            Reports reports = tracking.keep(report);
            PioneerState now = reported.last();
            if (now != null) {
                reported.set(now.with(reports));
            }
            // Last: who waits for a fresh report looks into the state next.
            subscriptions.heard(report);
            owner.heardMore();
        }
    }

    private void heard(@Nullable Sip sip) {
        StateTracker tracking = tracker;
        if (sip != null && tracking != null) {
            PioneerState now = tracking.track(sip, time.nanos());
            reported.set(now);
            if (!now.isMoving()) {
                velocity.release();
            }
            driving.look(now);
            owner.heard(this, now);
        }
    }

    @Override
    public void ended(LinkLost cause) {
        inbox.end(cause);
        if (hasBegun()) {
            owner.lost(this, cause);
        }
    }

    /** Does what the silence on either end asks for; to be called every {@link LinkWatch#PERIOD_S}. */
    public void watch() {
        PioneerState now = reported.last();
        if (now != null && !line.hasEnded()) {
            LinkLost cause = watch.look(now);
            if (cause != null) {
                end(cause);
            }
        }
    }

    /** Asks for packets that somebody lacks, if the robot speaks: a request would bring a silent one's motion back to life. */
    public void request() {
        PioneerState now = reported.last();
        if (now != null && !velocity.areHeld() && time.secondsSince(now.atNanos()) < Subscriptions.SPEAKING_S) {
            subscriptions.request();
        }
    }

    private void end(LinkLost cause) {
        line.abort(cause);
        owner.lost(this, cause);
    }

    /** Stops the robot, switches its motors off, says good-bye and closes the link; bounded by little over a second. */
    public void finish() {
        if (hasBegun()) {
            new SessionClosing(line, autobaud, changes).run();
        }
        line.close();
    }

    public boolean hasReported() {
        return reported.isKnown();
    }

    /**
     * Sends packets, each in a write of its own.
     *
     * @throws LinkLost if the line is dead or takes nothing for a second
     */
    public void send(byte[]... packets) {
        line.send(packets);
    }

    /** Tells the robot its ramps, for as long as this session lasts. */
    public void tell(Ramps ramps) {
        line.send(ramps.packets());
    }

    Autobaud autobaud() {
        return autobaud;
    }

    public Subscriptions subscriptions() {
        return subscriptions;
    }

    public VelocitySetpoint velocity() {
        return velocity;
    }

    public MotorPower motors() {
        return motors;
    }

    public ContinuousDrive driving() {
        return driving;
    }

    /** How well the robot's bytes have come through. */
    public PacketCounts reception() {
        return line.reception();
    }

    public Model model() {
        return model;
    }

    /** Who it is; null during the handshake. */
    public @Nullable PioneerIdentity identity() {
        return identity;
    }

    /** Null until it has come; some robots never send it. */
    public @Nullable Config config() {
        return config;
    }

    /** The bumper segments that the robot has. */
    public Bumpers bumpers() {
        return Bumpers.of(model, config);
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
