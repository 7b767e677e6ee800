package majic.mavlink;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import javax.swing.JComponent;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotState;
import majic.bot.Fence;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.bot.Parameter;
import majic.bot.ParameterException;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.BotDriver;
import majic.driver.Motion;
import majic.driver.ParameterTable;
import majic.driver.RobotWait;
import majic.environment.BotEnvironment;
import majic.mavlink.frame.MavlinkMessageType;
import majic.mavlink.message.AutopilotVersion;
import majic.mavlink.message.ObstacleRing;
import majic.mavlink.message.RangeReading;
import majic.mavlink.message.StatusText;
import majic.mavlink.message.VehicleHeartbeat;
import majic.mavlink.motion.FailsafeText;
import majic.mavlink.motion.FlightFence;
import majic.mavlink.motion.VehicleMotion;
import majic.mavlink.panel.MavlinkPanel;
import majic.mavlink.panel.MavlinkReplay;
import majic.mavlink.panel.VehicleScene;
import majic.mavlink.parameters.NamedParameters;
import majic.mavlink.parameters.VehicleAccess;
import majic.mavlink.parameters.VehicleCommands;
import majic.mavlink.parameters.VehicleParameters;
import majic.mavlink.ranging.VehicleRanges;
import majic.mavlink.session.Received;
import majic.mavlink.session.VehicleClass;
import majic.mavlink.session.VehicleSession;
import majic.velocity.LastOdometry;
import org.jspecify.annotations.Nullable;

/**
 * A vehicle that speaks MAVLink. Rovers, boats and copters with ArduPilot 4 are driven by velocities, ten a second, and
 * each motion is controlled here by the position that the autopilot reports; the autopilot follows a velocity for 3 s
 * at most. A copter flies only inside a fence that was set, after the command {@code arm}. Planes and submarines are
 * shown, stopped and taken up or home; they are never armed and never moved otherwise.
 *
 * <p>The connection is given up when the vehicle has been silent for 3 s.
 */
public final class MajicMavlink extends BotDriver {
    private static final double HEARTBEAT_S = 1;
    private static final double CHECK_S = 0.25;
    private static final int OLDEST_MAJOR = 4;

    /** A vehicle without a position, as before its first fix, is connected after this time, seconds. */
    private static final double LOCATED_S = 2.5;

    private final MavlinkAddress address;
    private final AtomicReference<VehicleAccess.@Nullable Parts> parts = new AtomicReference<>();
    private final VehicleAccess access = new VehicleAccess(parts::get);
    private final VehicleParameters parameters = new VehicleParameters(access);
    private final VehicleCommands commands = new VehicleCommands(access);
    private final VehicleScenes scenes;
    private volatile @Nullable VehicleSession session;
    private volatile LastOdometry last = LastOdometry.NONE;
    private volatile int knownSystem;
    private volatile VehicleClass knownVehicle = VehicleClass.OTHER;
    private volatile boolean mayMove;
    private volatile boolean armByMotion;
    private volatile @Nullable FlightFence fence;
    private volatile boolean describesRanges;

    /** Whether MAJIC moved the vehicle when its clock went back. */
    private volatile boolean heldBefore;

    private volatile boolean stopsBoth;

    /**
     * Creates the driver of a vehicle, with the system's clock and no settings.
     *
     * @param address as users type it: {@code mavlink:udp://:14550}, {@code mavlink://192.168.1.20:5760},
     *     {@code mavlink:/dev/ttyUSB0?baud=57600}, with {@code ?system=3} for one of several
     * @throws BotException if it is no such address
     */
    public MajicMavlink(String address) {
        this(BotAddress.parse(address), BotEnvironment.plain());
    }

    /**
     * Creates the driver of a vehicle.
     *
     * @param address with the scheme {@code mavlink}
     * @param environment the clock and settings to use
     * @throws BotException if it is no such address; the message shows a right one
     */
    public MajicMavlink(BotAddress address, BotEnvironment environment) {
        super(
                new MavlinkType(),
                VehicleLimits.usual(MavlinkAddress.parse(address).radiusMm()),
                environment);
        this.address = MavlinkAddress.parse(address);
        this.scenes = new VehicleScenes(time());
        // Readers of messages leave out old ones, each by its own pace.
        table().measured(time()::nanos);
        parameters.describe(table());
        table().add(
                        Parameter.onOff("armByMotion", "whether a motion arms a rover or boat that is not armed"),
                        () -> Value.onOff(armByMotion))
                .kept()
                .writes(values -> armByMotion(values.get(0).isYes()));
        table().findOthers(new NamedParameters(access));
        every("mavlink heartbeat", HEARTBEAT_S, this::heartbeat);
        every("mavlink check", CHECK_S, this::check);
    }

    /** Sets whether a motion arms the vehicle; needs no connection. */
    void armByMotion(boolean arms) {
        armByMotion = arms;
    }

    private void heartbeat() {
        VehicleSession open = session;
        if (open != null) {
            open.heartbeat();
        }
    }

    private void check() {
        VehicleSession open = session;
        if (open != null) {
            open.check();
            stopBoth(open);
        }
    }

    /** Stops what MAJIC was moving when a second vehicle with its number was found, which may have followed too. */
    private void stopBoth(VehicleSession open) {
        VehicleAccess.Parts now = parts.get();
        if (stopsBoth && now != null && now.session() == open && !open.hasEnded()) {
            stopsBoth = false;
            now.motion().haltAhead();
        }
    }

    @Override
    protected double longestAgeS() {
        return LONGEST_AGE_S;
    }

    @Override
    protected void open() {
        VehicleAccess.Parts before = parts.getAndSet(null);
        last = before == null ? last : before.motion().last();
        // A robot stays the vehicle that it was first: another one may send there when the connection is lost.
        int wanted = address.system() == 0 ? knownSystem : address.system();
        heldBefore = false;
        stopsBoth = false;
        VehicleSession opening = new VehicleSession(address.endpoint(), wanted, waiting(), new Events());
        session = opening;
        opening.open();
        knownSystem = opening.system();
        knownVehicle = opening.vehicle();
        try {
            VehicleMotion motion = parts(opening).motion();
            waiting().awaitConnecting(() -> opening.hasEnded() || motion.isLocated(), LOCATED_S);
            begin(opening);
        } catch (RuntimeException e) {
            opening.close();
            throw e;
        }
        adviseAbout(opening);
    }

    private void begin(VehicleSession opened) {
        double fastest = VehicleLimits.fastest(opened);
        profile(VehicleLimits.profile(
                address.radiusMm(), fastest, !opened.vehicle().isOnSurface()));
        VehicleMotion motion = parts(opened).motion();
        VehicleCommands.NAMES.forEach(this::removeCommand);
        commands.of(opened.vehicle(), opened.modes()).forEach(this::add);
        table().renew(table -> {
            if (opened.vehicle() == VehicleClass.COPTER) {
                describeFence(table);
            }
        });
        motion.begin(mayMove);
        mayMove = false;
    }

    private void describeFence(ParameterTable table) {
        table.add(
                        Parameter.number("fence", Unit.MM, "greatest distance from home; MAJIC flies it only inside")
                                .within(1, FlightFence.LARGEST_MM)
                                .with(Parameter.number("lowest", Unit.MM, "least height in the air")
                                        .within(0, FlightFence.LARGEST_MM))
                                .with(Parameter.number("highest", Unit.MM, "greatest height")
                                        .within(1, FlightFence.LARGEST_MM)),
                        this::fenceNow)
                .kept()
                .writes(this::fence);
    }

    private Value fenceNow() {
        FlightFence now = fence;
        return now == null
                ? Value.unknown("not set")
                : Value.many(List.of(
                        Value.of(now.radiusMm(), Unit.MM),
                        Value.of(now.lowestMm(), Unit.MM),
                        Value.of(now.highestMm(), Unit.MM)));
    }

    private void fence(List<Value> values) {
        if (values.size() < 3) {
            throw new ParameterException("fence", "fence: RADIUS LOWEST HIGHEST are needed, in mm");
        }
        FlightFence set = new FlightFence(
                values.get(0).number(), values.get(1).number(), values.get(2).number());
        if (!set.isValid()) {
            throw new ParameterException("fence", "fence: HIGHEST has to be more than LOWEST");
        }
        fence = set;
    }

    /** The parts of a session; made by its first message that needs them, on whatever thread. */
    private VehicleAccess.Parts parts(VehicleSession of) {
        synchronized (parts) {
            VehicleAccess.Parts open = parts.get();
            if (open == null || open.session() != of) {
                open = new VehicleAccess.Parts(
                        of,
                        new VehicleMotion(new Owner(), of, VehicleLimits.dynamics(), last),
                        new VehicleRanges(of.reports(), time()));
                parts.set(open);
            }
            return open;
        }
    }

    /** Sends a notice about what MAJIC can do with the kind of vehicle and the version of its autopilot. */
    private void adviseAboutKind(VehicleSession opened) {
        Optional<AutopilotVersion> version = opened.version();
        if (!opened.modes().isKnown()) {
            notice("its autopilot is neither ArduPilot nor PX4, or the kind of vehicle is unknown: MAJIC shows it, but"
                    + " cannot stop it");
        } else if (opened.modes().isPx4()) {
            notice("its autopilot is PX4: MAJIC shows and stops it, but neither arms nor moves it otherwise than by "
                    + commandsOf(opened));
        } else if (!opened.vehicle().isMoved()) {
            notice("it is a " + opened.vehicle().title() + ": MAJIC shows and stops it, but neither arms nor moves it"
                    + " otherwise than by " + commandsOf(opened));
        } else if (version.isEmpty()) {
            notice("its autopilot has not reported its version: before ArduPilot 4, MAJIC shows and stops it, but its"
                    + " motions fail, because older versions ignore velocities");
        } else if (version.get().major() < OLDEST_MAJOR) {
            notice("its autopilot is ArduPilot " + version.get() + ": MAJIC shows and stops it, but its motions fail,"
                    + " because versions before 4 ignore velocities");
        }
    }

    private String commandsOf(VehicleSession opened) {
        return commands.of(opened.vehicle(), opened.modes()).stream()
                .map(command -> command.command().name())
                .collect(Collectors.joining(", "));
    }

    /** Sends notices about what matters before the vehicle moves. */
    private void adviseAbout(VehicleSession opened) {
        adviseAboutKind(opened);
        if (opened.vehicle() == VehicleClass.COPTER
                && fence == null
                && opened.modes().guided().isPresent()) {
            notice("it flies only after \"arm\", inside a fence: set fence RADIUS LOWEST HIGHEST, in mm from home");
        }
        if (FailsafeText.goesOn(opened)) {
            notice(
                    "if MAJIC ends without a stop, its own navigation goes on to where it was sent (FS_GCS_ENABLE is 0); to"
                            + " change that, set param/FS_GCS_ENABLE 1");
        }
    }

    /** The kind of vehicle and the version of its autopilot. */
    @Override
    public String introduction() {
        VehicleSession open = session;
        if (open == null || !isConnected()) {
            return super.introduction();
        }
        return super.introduction() + " (" + open.vehicle().title() + ", system " + open.system()
                + open.version().map(version -> ", version " + version).orElse("") + ")";
    }

    /** The kind of vehicle, once it was connected; stays when it cannot be connected again. */
    @Override
    public String kind() {
        VehicleClass vehicle = knownVehicle;
        return vehicle == VehicleClass.OTHER ? super.kind() : vehicle.label();
    }

    /** The connection and the number of the vehicle on it. */
    @Override
    public Optional<String> identity() {
        VehicleSession open = session;
        return open == null || open.system() == 0
                ? Optional.empty()
                : Optional.of(open.endpoint().key() + " system " + open.system());
    }

    @Override
    protected void shut() {
        VehicleAccess.Parts open = parts.get();
        VehicleSession closing = session;
        if (open != null && open.session() == closing) {
            open.motion().close();
        }
        if (closing != null) {
            closing.close();
        }
    }

    @Override
    protected void motionBegins() {
        VehicleAccess.Parts open = parts.get();
        if (open != null) {
            open.motion().begins(isDriving());
        }
    }

    @Override
    protected Value moveBy(double mm, Motion motion) {
        return alone(() -> motion().move(mm, cruiseMmPerSec(), motion));
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        return alone(() -> motion().turn(degrees, cruiseTurnDegPerSec(), motion));
    }

    /** Does what moves the vehicle; fails before, or with that reason, if it is not the only one with its number. */
    private Value alone(Supplier<Value> moves) {
        VehicleSession open = connected().session();
        open.failIfDoubled();
        try {
            return moves.get();
        } catch (MotionFailed e) {
            open.failIfDoubled();
            throw e;
        }
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        connected().session().failIfDoubled();
        motion().drive(mmPerSec, degPerSec);
    }

    /** A vehicle that others fly is not stopped because MAJIC is closed. */
    @Override
    protected void haltAhead() {
        VehicleMotion moving = motion();
        if (connection() != Connection.CLOSED || moving.isHeld() || moving.isMovingOnSurface()) {
            moving.haltAhead();
        }
    }

    @Override
    protected void halt() {
        motion().halt();
    }

    @Override
    public void confirmHalt() {
        VehicleAccess.Parts open = connected();
        if (open.session().isDoubled()) {
            throw new BotException(
                    name() + " has the number of another vehicle, so its stop, which was sent to both, is"
                            + " not confirmed; look at both");
        }
        open.motion().confirmHalt();
    }

    private VehicleMotion motion() {
        return connected().motion();
    }

    private VehicleAccess.Parts connected() {
        VehicleAccess.Parts open = parts.get();
        if (open == null) {
            throw new BotException(name() + " is not connected");
        }
        return open;
    }

    /** The range finders that have reported so far. */
    @Override
    public List<RangeSensor> rangeSensors() {
        VehicleAccess.Parts open = parts.get();
        return open == null ? List.of() : open.ranges().sensors();
    }

    /**
     * Returns the newest texts of the autopilot, at most 50 since the vehicle was connected.
     *
     * @return the oldest first; empty before the first connection
     */
    public List<StatusText> texts() {
        VehicleAccess.Parts open = parts.get();
        return open == null ? List.of() : open.session().texts().all();
    }

    /** The circle of a copter's fence over the ground, once the copter was armed by MAJIC's command. */
    @Override
    public Optional<Fence> fence() {
        VehicleAccess.Parts open = parts.get();
        FlightFence set = fence;
        return open == null || set == null
                ? Optional.empty()
                : open.motion()
                        .home()
                        .map(odometryOrigin()::plus)
                        .map(home -> new Fence(home.xMm(), home.yMm(), set.radiusMm()));
    }

    @Override
    public JComponent display() {
        return MavlinkPanel.create(this, this::scene);
    }

    @Override
    public Map<String, String> displayState() {
        return scene().map(MavlinkReplay::texts).orElse(Map.of());
    }

    /** Returns what the panel shows; empty before the first connection, and while it is made. */
    private Optional<VehicleScene> scene() {
        VehicleAccess.Parts open = parts.get();
        return open == null ? Optional.empty() : Optional.of(scenes.scene(open.session()));
    }

    private void publishRanges(VehicleAccess.Parts open, MavlinkMessageType type) {
        if (!describesRanges && open.ranges().areThere()) {
            describesRanges = true;
            parameters.describeRanges(table(), this::profile);
        }
        Optional<Pose> pose = open.motion().poseNow();
        if (!hasScanListeners() || pose.isEmpty()) {
            return;
        }
        double now = time().nanos() / 1e9;
        VehicleRanges ranges = open.ranges();
        if (type == MavlinkMessageType.OBSTACLE_DISTANCE) {
            open.session()
                    .reports()
                    .newest(ObstacleRing.class)
                    .map(Received::value)
                    .filter(ObstacleRing::isUsable)
                    .ifPresent(ring ->
                            publishScan(new RangeScan(ranges.sensor(ring), now, pose.get(), ranges.ranges(ring))));
        } else {
            open.session().reports().ranges().values().stream()
                    .max(Comparator.comparingLong(Received::atNanos))
                    .map(Received::value)
                    .filter(RangeReading::isHorizontal)
                    .ifPresent(reading ->
                            publishScan(new RangeScan(ranges.sensor(reading), now, pose.get(), (float) reading.mm())));
        }
    }

    /** Handles what happens in the session. */
    private final class Events implements VehicleSession.Listener {
        @Override
        public void moved(VehicleSession from) {
            if (from == session && !from.isDoubled()) {
                parts(from).motion().moved();
            }
        }

        @Override
        public void heartbeat(VehicleSession from, VehicleHeartbeat heartbeat) {
            if (from == session) {
                parts(from).motion().heartbeat(heartbeat);
                news();
            }
        }

        @Override
        public void reported(VehicleSession from, MavlinkMessageType type) {
            if (from != session) {
                return;
            }
            if (type == MavlinkMessageType.GLOBAL_POSITION_INT) {
                parts(from).motion().located();
            }
            if (type == MavlinkMessageType.DISTANCE_SENSOR || type == MavlinkMessageType.OBSTACLE_DISTANCE) {
                publishRanges(parts(from), type);
            }
            news();
        }

        @Override
        public void restarted(VehicleSession from) {
            if (from == session) {
                heldBefore = parts(from).motion().isHeld();
                parts(from).motion().restarted();
                MajicMavlink.this.notice("the autopilot has restarted");
            }
        }

        @Override
        public void doubled(VehicleSession from) {
            if (from == session) {
                VehicleMotion motion = parts(from).motion();
                stopsBoth = heldBefore || motion.isHeld() || motion.isMoving();
                motion.restarted();
            }
        }

        @Override
        public void lost(VehicleSession from, LinkLost cause) {
            VehicleAccess.Parts open = parts.get();
            if (from != session) {
                return;
            }
            String after = "";
            if (open != null && open.session() == from) {
                mayMove |= open.motion().isHeld() || open.motion().isMoving();
                after = open.motion().afterLoss();
                open.motion().end();
            }
            MajicMavlink.this.lost(new LinkLost(cause.getMessage() + after, cause));
        }

        @Override
        public void said(VehicleSession from, String text) {
            if (from == session) {
                parts(from).motion().said(text);
            }
        }

        @Override
        public boolean isExpected(String text) {
            VehicleAccess.Parts open = parts.get();
            return open != null && open.motion().isExpected(text);
        }

        @Override
        public void notice(String message) {
            MajicMavlink.this.notice(message);
        }
    }

    /** The driver as its motions use it. */
    private final class Owner implements VehicleMotion.MotionOwner {
        @Override
        public String name() {
            return MajicMavlink.this.name();
        }

        @Override
        public RobotWait waiting() {
            return MajicMavlink.this.waiting();
        }

        @Override
        public void once(String what, double seconds, Runnable task) {
            MajicMavlink.this.once(what, seconds, task);
        }

        @Override
        public void publish(BotState state) {
            MajicMavlink.this.publish(state);
        }

        @Override
        public void notice(String message) {
            MajicMavlink.this.notice(message);
        }

        @Override
        public boolean armsByMotion() {
            return armByMotion;
        }

        @Override
        public @Nullable FlightFence fence() {
            return fence;
        }
    }
}
