package majic.ros;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JComponent;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotState;
import majic.bot.LinkLost;
import majic.bot.Parameter;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.bot.Value;
import majic.driver.BotDriver;
import majic.driver.Motion;
import majic.driver.RobotWait;
import majic.environment.BotEnvironment;
import majic.ros.graph.KnownRobot;
import majic.ros.graph.KnownRobots;
import majic.ros.message.CompressedPicture;
import majic.ros.message.OdometryMessage;
import majic.ros.panel.RosPanel;
import majic.ros.panel.RosPictureFile;
import majic.ros.panel.RosReplay;
import majic.ros.panel.RosScene;
import majic.ros.parameters.RosParameters;
import majic.ros.readings.RequestedReading;
import majic.ros.readings.RosReadings;
import majic.velocity.BaseOwner;
import majic.velocity.LastOdometry;
import majic.velocity.ObstructionSource;
import majic.velocity.VelocityMotion;
import majic.velocity.VelocityMotion.PoseSource;
import org.jspecify.annotations.Nullable;

/**
 * A robot that speaks ROS 1 or ROS 2, through a rosbridge server. Its topics are found by their types, its model by a
 * table. Motions are controlled here by its odometry, and velocities are published 20 times a second while it moves.
 *
 * <p>The connection is given up when the server has sent nothing for 0.9 s, answers to pings included. The server does
 * not stop a robot whose client is gone: whether it stops by itself depends on the model, and is shown by the parameter
 * {@code timeout}.
 */
public final class MajicRos extends BotDriver {
    private static final double RENEWAL_S = 1;

    /** A scan whose time is farther from that of any odometry is left out. */
    private static final double LONGEST_TO_ODOMETRY_S = 0.5;

    private final RosAddress address;
    private final AtomicReference<@Nullable RosSession> session = new AtomicReference<>();
    private final Owner owner = new Owner();
    private final RosSensing sensing;
    private final PoseHistory poses = new PoseHistory();
    private final RosScenes scenes = new RosScenes(time());
    private final AtomicInteger cameraViews = new AtomicInteger();
    private volatile boolean hasOdometry;
    private volatile @Nullable VelocityMotion motions;
    private volatile LastOdometry last = LastOdometry.NONE;
    private volatile boolean mayMove;

    /**
     * Creates the driver of a robot, with the system's clock and no settings.
     *
     * @param address as users type it: {@code ros://192.168.1.20}, {@code ros://192.168.1.20:9090/robot1}
     * @throws BotException if it is no such address
     */
    public MajicRos(String address) {
        this(BotAddress.parse(address), BotEnvironment.plain());
    }

    /**
     * Creates the driver of a robot.
     *
     * @param address with the scheme {@code ros} or {@code ross}
     * @param environment the clock and settings to use
     * @throws BotException if it is no such address; the message shows a right one
     */
    public MajicRos(BotAddress address, BotEnvironment environment) {
        super(new RosType(), RosProfiles.profile(KnownRobots.UNKNOWN, false), environment);
        this.address = RosAddress.parse(address);
        JsonLibrary.require();
        // Readers of topics leave out old messages, by the pace of each topic.
        table().measured(time()::nanos);
        this.sensing = new RosSensing(table(), waiting(), () -> profile().bodyMm(), this::state, new SensorEvents());
        describe();
        every("ros subscriptions", RENEWAL_S, this::renew);
    }

    private void describe() {
        table().add(Parameter.text("model", "which robot of the table it is"), () -> Value.text(robot().name()));
        table().add(
                        Parameter.text("timeout", "what it does when commands end without a stop"),
                        () -> Value.text(robot().afterCommands()));
    }

    private KnownRobot robot() {
        RosSession open = session.get();
        return open == null ? KnownRobots.UNKNOWN : open.robot();
    }

    @Override
    protected void open() {
        RosSession opening = new RosSession(address, waiting(), new SessionEvents());
        VelocityMotion before = motions;
        last = before == null ? last : before.last();
        motions = null;
        session.set(opening);
        try {
            opening.find(RobotTables.read(settings(), this::notice));
            begin(opening);
        } catch (RuntimeException e) {
            opening.abort();
            throw e;
        }
        adviseAbout(opening);
    }

    /** A base without odometry reports nothing that could be old: its pose follows from the commands. */
    @Override
    protected double longestAgeS() {
        return hasOdometry ? LONGEST_AGE_S : Double.POSITIVE_INFINITY;
    }

    private void begin(RosSession opening) {
        hasOdometry = opening.base().odometry() != null;
        profile(RosProfiles.profile(opening.robot(), !hasOdometry));
        VelocityMotion next = new VelocityMotion(
                owner,
                opening,
                RosProfiles.dynamics(opening.robot()),
                last,
                hasOdometry ? PoseSource.ODOMETRY : PoseSource.COMMANDS);
        motions = next;
        opening.advertise();
        sensing.begin(opening);
        requestScans();
        RosParameters.COMMANDS.forEach(this::removeCommand);
        sensing.commands().forEach(this::add);
        next.begin(mayMove);
        opening.awaitOdometry();
        sensing.awaitFirst();
        opening.watch();
        mayMove = false;
    }

    /** Sends notices about what matters before the robot moves. */
    private void adviseAbout(RosSession opened) {
        KnownRobot robot = opened.robot();
        if (opened.base().odometry() == null) {
            notice(
                    "it has no odometry: its distances and angles are calculated from the commands, and nothing confirms that"
                            + " a stop has stopped it");
        }
        if (Double.isInfinite(robot.timeoutS())) {
            notice("a " + robot.name()
                    + " keeps its last velocity when the connection is lost: be ready to stop it at the robot");
        } else if (Double.isNaN(robot.timeoutS())) {
            notice(
                    "whether it stops by itself when the connection is lost is not known: be ready to stop it at the robot");
        }
        if (!robot.note().isEmpty()) {
            notice(robot.note());
        }
        if (address.camera() == null) {
            sensing.cameraNotice().ifPresent(this::notice);
        }
    }

    /** The model and the version of ROS. */
    @Override
    public String introduction() {
        RosSession open = session.get();
        if (open == null || !isConnected()) {
            return super.introduction();
        }
        return super.introduction() + " (" + open.robot().name() + ", "
                + open.graph().title() + ", drives by " + open.base() + ")";
    }

    /** The server and the topic that takes the velocities: two connections with the same ones drive one base. */
    @Override
    public Optional<String> identity() {
        RosSession open = session.get();
        return open == null ? Optional.empty() : open.identity();
    }

    @Override
    protected void shut() {
        VelocityMotion moving = motions;
        if (moving != null) {
            moving.close();
        }
        RosSession open = session.get();
        if (open != null) {
            open.close();
        }
    }

    @Override
    protected Value moveBy(double mm, Motion motion) {
        return motions().move(mm, cruiseMmPerSec(), motion);
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        return motions().turn(degrees, cruiseTurnDegPerSec(), motion);
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        motions().drive(mmPerSec, degPerSec);
    }

    @Override
    protected void halt() {
        try {
            motions().halt();
        } finally {
            sensing.halt();
        }
    }

    @Override
    public void confirmHalt() {
        motions().confirmHalt();
    }

    private VelocityMotion motions() {
        VelocityMotion moving = motions;
        if (moving == null) {
            throw new BotException(name() + " is not connected");
        }
        return moving;
    }

    /** The session there is. */
    RosSession session() {
        RosSession open = session.get();
        if (open == null) {
            throw new BotException(name() + " is not connected");
        }
        return open;
    }

    @Override
    public JComponent display() {
        return RosPanel.create(this, this::scene, this::watchCamera);
    }

    @Override
    public Map<String, String> displayState() {
        return scene().map(RosReplay::texts).orElse(Map.of());
    }

    /**
     * The laser scanners and the single beams, as their newest messages describe them: one whose messages change is
     * another one.
     */
    @Override
    public List<RangeSensor> rangeSensors() {
        RosReadings readings = sensing.readings();
        return readings == null ? List.of() : readings.rangeSensors();
    }

    /** Sending may block. */
    @Override
    protected void scansRequested(boolean requested) {
        once("ros scans", 0, this::requestScans);
    }

    private void requestScans() {
        RosReadings readings = sensing.readings();
        if (readings != null) {
            readings.requestScans(hasScanListeners());
        }
    }

    @Override
    public boolean hasCamera() {
        RosReadings readings = sensing.readings();
        return readings != null && readings.camera().isPresent();
    }

    @Override
    public byte[] takePicture() {
        RosReadings readings = sensing.readings();
        if (readings == null || readings.camera().isEmpty()) {
            return super.takePicture();
        }
        return readings.camera()
                .flatMap(RequestedReading::read)
                .map(picture -> RosPictureFile.jpeg(picture.file()))
                .orElseThrow(() -> new BotException("no picture has arrived from the camera"));
    }

    /** Returns what the panel shows; empty before the first connection. */
    private Optional<RosScene> scene() {
        RosSession open = session.get();
        RosReadings readings = sensing.readings();
        return open == null || readings == null
                ? Optional.empty()
                : Optional.of(scenes.scene(this, open.connections(), readings));
    }

    /**
     * Pictures are requested while a panel shows them; sending may block, so it does not happen on the event thread.
     */
    private void watchCamera(boolean seen) {
        if (cameraViews.addAndGet(seen ? 1 : -1) == 1 && seen) {
            once("ros camera", 0, this::requestPictures);
        }
    }

    private void requestPictures() {
        RosReadings readings = sensing.readings();
        if (cameraViews.get() > 0 && readings != null && isConnected()) {
            readings.camera().ifPresent(RequestedReading::request);
        }
    }

    private void renew() {
        RosSession open = session.get();
        if (open != null && connection() != Connection.LOST) {
            open.renewSubscriptions();
            requestPictures();
            requestScans();
            sensing.endUnused();
        }
    }

    /** Handles what happens in the session. */
    private final class SessionEvents implements RosSession.Events {
        @Override
        public void odometry(RosSession from, OdometryMessage reading, long measuredNanos) {
            VelocityMotion moving = motions;
            if (from == session.get() && moving != null) {
                sensing.odometry(reading);
                moving.reported(reading.pose(), reading.speedMmPerSec(), reading.turnRateDegPerSec(), measuredNanos);
            }
        }

        @Override
        public void unusable(RosSession from, String reason) {
            VelocityMotion moving = motions;
            if (from == session.get() && moving != null) {
                moving.unusable(reason);
            }
        }

        @Override
        public void lost(RosSession from, LinkLost cause) {
            VelocityMotion moving = motions;
            if (from != session.get() || moving == null) {
                return;
            }
            mayMove |= moving.isMoving();
            String message = "connection lost: " + cause.getMessage() + moving.afterLoss();
            moving.end();
            MajicRos.this.lost(new LinkLost(message, cause));
        }

        @Override
        public void notice(String message) {
            MajicRos.this.notice(message);
        }
    }

    /** Handles what the sensors report. */
    private final class SensorEvents implements RosReadings.Events {
        @Override
        public void news() {
            MajicRos.this.news();
        }

        /** The recorder takes only JPEG files. */
        @Override
        public void picture(CompressedPicture picture) {
            publishPicture(() -> RosPictureFile.jpeg(picture.file()));
        }

        @Override
        public void scanned(RangeSensor sensor, long measuredNanos, float... rangesMm) {
            poses.at(measuredNanos, hasOdometry ? LONGEST_TO_ODOMETRY_S : Double.POSITIVE_INFINITY)
                    .ifPresent(pose -> publishScan(new RangeScan(sensor, measuredNanos / 1e9, pose, rangesMm)));
        }

        @Override
        public void notice(String message) {
            MajicRos.this.notice(message);
        }
    }

    /** The driver as its motions use it. */
    private final class Owner implements BaseOwner {
        @Override
        public String name() {
            return MajicRos.this.name();
        }

        @Override
        public RobotWait waiting() {
            return MajicRos.this.waiting();
        }

        @Override
        public ObstructionSource obstructions() {
            return sensing;
        }

        @Override
        public double roundTripS() {
            return session().roundTripS();
        }

        @Override
        public void once(String what, double seconds, Runnable task) {
            MajicRos.this.once(what, seconds, task);
        }

        @Override
        public void every(String what, double seconds, Runnable task) {
            MajicRos.this.every(what, seconds, task);
        }

        @Override
        public void publish(BotState state) {
            poses.add(state);
            MajicRos.this.publish(state);
        }

        @Override
        public void notice(String message) {
            MajicRos.this.notice(message);
        }
    }
}
