package majic.pioneer;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import javax.swing.JComponent;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.bot.BotState;
import majic.bot.LinkLost;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.bot.Value;
import majic.driver.BotDriver;
import majic.driver.Motion;
import majic.environment.BotEnvironment;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.arcos.PioneerIdentity;
import majic.pioneer.line.ArcosHandshake;
import majic.pioneer.panel.PioneerPanel;
import majic.pioneer.panel.PioneerReplay;
import majic.pioneer.panel.PioneerScene;
import majic.pioneer.parameters.PioneerAccess;
import majic.pioneer.parameters.PioneerCommands;
import majic.pioneer.parameters.PioneerParameters;
import majic.pioneer.parameters.RampParameters;
import majic.pioneer.session.ConnectWait;
import majic.pioneer.session.LinkWatch;
import majic.pioneer.session.Maneuver;
import majic.pioneer.session.MotionTarget;
import majic.pioneer.session.PioneerConnection;
import majic.pioneer.session.PioneerSession;
import majic.pioneer.state.Equipment;
import majic.pioneer.state.Limits;
import majic.pioneer.state.Model;
import majic.pioneer.state.Models;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.Ramps;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * A MobileRobots Pioneer over TCP or a serial port, by the ARCOS protocol or through the maker's library ARIA. Motions
 * are controlled here at every SIP, about ten times a second, and end within 10 mm and 1 degree by the robot's
 * odometry. Velocities are sent in whole mm/s and deg/s.
 *
 * <p>When a moving robot sends no SIP for 0.5 s, zero velocities are sent and then nothing more; after 1 s (3 s if it
 * is stationary) the connection is given up. The robot's own watchdog stops it 2 s after the last packet.
 */
public final class MajicPioneer extends BotDriver {
    /** Long enough to brake from the highest speed, seconds. */
    private static final double HALT_S = 3;

    private static final double EMERGENCY_S = 1;

    private final PioneerAddress address;
    private final Function<ConnectWait, PioneerConnection> connections;
    private final AtomicReference<@Nullable PioneerSession> session = new AtomicReference<>();
    private final PioneerParameters parameters;
    private final PioneerCommands commands;
    private volatile Pose lastPose = Pose.START;
    private final Object rampLock = new Object();
    private volatile @Nullable Ramps requestedRamps;

    /**
     * Creates the driver of a robot, with the system's clock and no settings.
     *
     * @param address as users type it: {@code pioneer://10.0.0.5}, {@code pioneer:/dev/ttyS0},
     *     {@code pioneer+aria://10.0.0.5}, {@code pioneer://10.0.0.5?params=p3at.p}
     * @throws BotException if it is no such address, the library that it names is missing, or its parameter file is
     *     wrong
     */
    public MajicPioneer(String address) {
        this(BotAddress.parse(address), BotEnvironment.plain());
    }

    /**
     * Creates the driver of a robot.
     *
     * @param address may name a library, or a parameter file
     * @param environment the clock and settings to use
     * @throws BotException if it is no such address, the library is missing, or the parameter file is wrong; the
     *     message says what is right
     */
    public MajicPioneer(BotAddress address, BotEnvironment environment) {
        this(PioneerAddress.parse(address), environment);
    }

    private MajicPioneer(PioneerAddress address, BotEnvironment environment) {
        this(address, PioneerConnections.of(address.place(), environment), environment);
    }

    /**
     * Creates the driver of a robot.
     *
     * @param address as users type it
     * @param connections makes the connection of each session
     */
    MajicPioneer(
            PioneerAddress address, Function<ConnectWait, PioneerConnection> connections, BotEnvironment environment) {
        super(new PioneerType(), Models.USUAL.profile(Ramps.careful(Limits.of(Models.USUAL, null))), environment);
        this.address = address;
        this.connections = connections;
        PioneerAccess access = new PioneerAccess(session::get);
        RampParameters pace = new RampParameters(access, this::useRamps);
        this.parameters = new PioneerParameters(table(), PioneerParameters.themes(this, access, pace));
        this.commands = new PioneerCommands(access);
        describe(Equipment.of(Models.USUAL, null));
        watchAgain(LinkWatch.PERIOD_S);
    }

    /** Describes the parameters and commands of a robot with this equipment. */
    void describe(Equipment equipment) {
        describeParameters(equipment);
        PioneerCommands.NAMES.forEach(this::removeCommand);
        commands.with(equipment).forEach(this::add);
    }

    /** A laser may be found while the equipment is described. */
    private void describeParameters(Equipment equipment) {
        synchronized (parameters) {
            parameters.describe(equipment);
        }
    }

    /** Refuses a change during a motion, whose braking is planned with the ramps in force. */
    private void useRamps(UnaryOperator<Ramps> change) {
        PioneerSession open = current();
        if (isBusy() && !isDriving()) {
            throw new BotException(name() + " is moving; its acceleration can be set when it is stationary");
        }
        synchronized (rampLock) {
            requestedRamps = change.apply(open.ramps());
            open.use(requestedRamps);
            adoptProfile(open);
        }
    }

    private void adoptProfile(PioneerSession open) {
        BotProfile found = open.equipment().model().profile(open.ramps());
        if (!found.equals(profile())) {
            profile(found);
        }
    }

    @Override
    protected void open() {
        try {
            openOnce();
        } catch (ArcosHandshake.SessionClosed e) {
            openOnce();
        }
    }

    private void openOnce() {
        ConnectWait wait = new ConnectWait(waiting(), () -> connection() == Connection.CLOSED);
        PioneerSession opening =
                new PioneerSession(connections.apply(wait), wait, lastPose, address::model, new SessionEvents());
        session.set(opening);
        opening.open(requestedRamps);
        try {
            adopt(opening);
        } catch (RuntimeException e) {
            opening.close();
            throw e;
        }
    }

    private void adopt(PioneerSession opened) {
        Model model = opened.equipment().model();
        if (!model.known()) {
            notice(address.unscaled(model.subclass()));
        }
        address.otherModel(model.subclass()).ifPresent(this::notice);
        Config config = opened.config();
        if (config != null && config.isWithoutWatchdog()) {
            notice("its watchdog is off: when the connection is lost, it drives on until something stops it; set"
                    + " WATCHDOG in its controller, 2000 ms from the factory");
        }
        adoptProfile(opened);
        describe(opened.equipment());
    }

    /** The kind of robot with its model and the name given by its owner (ARCOS sheet 4). */
    @Override
    public String introduction() {
        PioneerSession open = session.get();
        PioneerIdentity known = open == null ? null : open.identity();
        return known == null ? super.introduction() : super.introduction() + known.details();
    }

    @Override
    protected void shut() {
        PioneerSession open = session.get();
        if (open != null) {
            open.close();
        }
    }

    @Override
    protected Value moveBy(double mm, Motion motion) {
        PioneerSession open = scaled();
        return Maneuver.run(open, new MotionTarget.Straight(open.state(), mm, cruiseMmPerSec(), open.ramps()), motion);
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        PioneerSession open = scaled();
        return Maneuver.run(
                open, new MotionTarget.Turning(open.state(), degrees, cruiseTurnDegPerSec(), open.ramps()), motion);
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        current().motors().drive(mmPerSec, degPerSec);
    }

    @Override
    protected void halt() {
        current().motors().stop();
        commands.halt();
    }

    /** A robot that is not stationary in time is stopped as hard as possible. */
    @Override
    public void confirmHalt() {
        PioneerSession open = current();
        parameters.halt();
        if (WaitPolicy.isAllowed() && !open.awaitStopped(HALT_S)) {
            open.send(ArcosCommand.ESTOP.packet());
            if (!open.awaitStopped(EMERGENCY_S)) {
                throw new BotException(name() + " has not reported its stop within " + (int) (HALT_S + EMERGENCY_S)
                        + " s of the stop");
            }
        }
    }

    @Override
    public JComponent display() {
        return PioneerPanel.create(this, this::scene);
    }

    /**
     * Returns {@code sonar}, whose scans have the ranges that are new in a report of the robot, and {@code laser}, if
     * it is a simulated robot with one, or a robot with one to which ARIA connects.
     *
     * @return known once the robot is connected, but for the laser, which is known from its first scan on: with a
     *     simulated robot at most half a second later, which is awaited if the thread may wait; through ARIA as long as
     *     ARIA takes to start it
     */
    @Override
    public List<RangeSensor> rangeSensors() {
        PioneerSession open = session.get();
        return open == null ? List.of() : open.rangeSensors();
    }

    @Override
    protected double longestAgeS() {
        return LONGEST_AGE_S;
    }

    @Override
    public Map<String, String> displayState() {
        return scene().map(PioneerReplay::texts).orElse(Map.of());
    }

    private Optional<PioneerScene> scene() {
        return Optional.ofNullable(session.get())
                .filter(PioneerSession::hasReported)
                .map(this::scene);
    }

    private PioneerScene scene(PioneerSession open) {
        PioneerState state = open.state();
        return new PioneerScene(
                open.equipment().model(),
                state,
                open.laser().fresh(),
                open.equipment().bumpers(),
                connection(),
                get("age").number(),
                state.sipsPerSec(),
                Objects.requireNonNullElse(open.packetCounts(), PacketCounts.NONE),
                profile().speed(),
                profile().turn());
    }

    /** Returns the session; throws a {@link BotException} before the first connect. */
    private PioneerSession current() {
        PioneerSession open = session.get();
        if (open == null) {
            throw new BotException(name() + " is not connected");
        }
        return open;
    }

    /** Returns the session of a robot whose counts can be converted; throws a {@link BotException} for another. */
    private PioneerSession scaled() {
        PioneerSession open = current();
        Model model = open.equipment().model();
        if (!model.known()) {
            throw new BotException(address.unscaled(model.subclass()));
        }
        return open;
    }

    private void watchAgain(double seconds) {
        once("link watch", seconds, this::watch);
    }

    private void watch() {
        double againS = LinkWatch.PERIOD_S;
        try {
            PioneerSession open = session.get();
            if (open != null && isConnected()) {
                againS = open.checkLink();
                open.requestReports(hasScanListeners());
            }
        } finally {
            watchAgain(againS);
        }
    }

    /** The session there is; null before the first connect. */
    @Nullable
    PioneerSession session() {
        return session.get();
    }

    private void publish(PioneerSession from, PioneerState state) {
        if (from == session.get()) {
            lastPose = state.pose();
            boolean moving = state.isMoving() || from.motors().isMoving();
            publish(new BotState(
                    state.pose(), state.speedMmPerSec(), state.turnRateDegPerSec(), moving, state.atNanos()));
            if (hasScanListeners()) {
                from.sonars().flatMap(sonars -> sonars.scan(state)).ifPresent(this::publishScan);
            }
        }
    }

    /** Handles what happens in the session. */
    private final class SessionEvents implements PioneerSession.Listener {
        @Override
        public void stateReported(PioneerSession from, PioneerState state) {
            publish(from, state);
        }

        @Override
        public void laserFound(PioneerSession from) {
            if (from == session.get()) {
                describeParameters(from.equipment());
                news();
            }
        }

        @Override
        public void scanned(PioneerSession from, RangeScan scan) {
            if (from == session.get()) {
                publishScan(scan);
            }
        }

        @Override
        public void otherReported() {
            news();
        }

        @Override
        public void lost(PioneerSession from, LinkLost cause) {
            if (from == session.get()) {
                MajicPioneer.this.lost(cause);
            }
        }

        @Override
        public void notice(String message) {
            MajicPioneer.this.notice(message);
        }
    }
}
