package majic.shared;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.NumericNode;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import javax.swing.JComponent;
import majic.bot.BotAddress;
import majic.bot.BotCommand;
import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.bot.BotState;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Range;
import majic.bot.RangeSensor;
import majic.bot.Uncertainty;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.BotDriver;
import majic.driver.DriverCommand;
import majic.driver.Motion;
import majic.driver.RobotWait;
import majic.driver.TeamMembership;
import majic.environment.BotEnvironment;
import majic.shared.broker.PublicationRefused;
import majic.shared.message.Description;
import majic.shared.message.RequestReply;
import majic.shared.message.RequestedAction;
import majic.shared.message.RobotMessage;
import majic.shared.message.RobotState;
import majic.shared.message.ScanMessage;
import majic.shared.panel.SharedPanel;
import majic.shared.panel.SharedReplay;
import majic.shared.panel.SharedScene;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * A robot that another desk shares through a broker. It has the parameters, the commands and the type that its desk
 * describes; motions are performed and guarded there. While this program holds the robot, it publishes a heartbeat; its
 * desk stops the robot when the heartbeat is missing for a second.
 *
 * <p>The connection is given up when the broker, the desk or the desk's connection to the robot is lost, and when no
 * state has arrived for 3 s.
 */
public final class MajicShared extends BotDriver {
    private static final Logger LOG = System.getLogger(MajicShared.class.getName());
    private static final BotProfile UNKNOWN =
            new BotProfile(200, new Range(-1000, 1000), new Range(-180, 180), 100, 45, 300, false);

    private static final double FIRST_SIGN_S = 3;

    /** A program that has just been started on a busy computer needs seconds to read its first messages. */
    private static final double FIRST_STATE_S = 8;

    private static final double TICK_S = 0.25;

    /** Without a state for longer than this the connection is lost, after 3 s at most. */
    private static final double SILENCE_S = 3 - TICK_S;

    /** An older scan is not used as a new one. */
    private static final double OLDEST_SCAN_S = 1;

    private static final long NO_STOPS_KNOWN = -1;

    /** Its desk performs it by the navigation of the robot, if that has one. */
    private static final String GOTO = "goto";

    /** Parameters that the desk does not have, or that have other values there. */
    private static final Pattern ONLY_HERE = Pattern.compile("(?i)\\b(desk|holder|delay|age)\\b");

    private final SharedAddress address;
    private final SharedType shared;
    private final BotEnvironment environment;
    private final RobotWait waiting;
    private final RemoteStop stop;
    private final RemoteMotions motions;
    private final DescribedParameters described;
    private final DeskFrame frame = new DeskFrame(this);
    private final DelayMeter delay = new DelayMeter(this::toDesk);
    private final Set<String> commandNames = new HashSet<>();
    private volatile @Nullable RobotFeed feed;
    private volatile @Nullable RobotCommands commands;
    private volatile @Nullable Description description;

    /** How often the robot was stopped, by the newest state; used by the thread of the connection. */
    private volatile long stopsAtDesk = NO_STOPS_KNOWN;

    /**
     * Creates the driver of a robot.
     *
     * @param address with the scheme {@code mqtt} or {@code mqtts}
     * @param shared has the connections to brokers
     * @param environment the clock and settings to use
     * @throws BotException if it is no such address; the message shows a right one
     */
    public MajicShared(BotAddress address, SharedType shared, BotEnvironment environment) {
        super(shared, UNKNOWN, environment);
        this.address = SharedAddress.parse(address);
        this.shared = shared;
        this.environment = environment;
        this.waiting = waiting();
        this.stop = new RemoteStop(this::toDesk, waiting, this.address.title());
        this.motions = new RemoteMotions(this::toDesk, waiting, stop, new AtDesk());
        this.described = new DescribedParameters(motions, this::values, this::isFeeding);
        describe();
        every("shared robot", TICK_S, this::tick);
    }

    private void describe() {
        table().add(Parameter.text("desk", "which desk shares it"), () -> Value.text(address.desk()))
                .kept();
        table().add(Parameter.text("holder", "who may move it now"), () -> Value.text(holder().toString()));
        table().add(Parameter.number("delay", Unit.MS, "from a request to the answer of its desk"), delay::delay);
        add(new DriverCommand(
                "hold", List.of(), false, "keeps others from moving it until free", (none, motion) -> hold()));
        add(new DriverCommand("free", List.of(), false, "lets others move it", (none, motion) -> free()));
        add(new DriverCommand(
                GOTO,
                List.of(
                        Parameter.number("x", Unit.MM, "as in pose"),
                        Parameter.number("y", Unit.MM, "as in pose")
                                .with(Parameter.number("heading", Unit.DEG, "at the end; without it, any"))),
                true,
                "drives to a place, around what is in the way, by the map of its desk",
                this::goTo));
    }

    private String goTo(List<Value> place, Motion motion) {
        boolean withHeading = place.size() > 2;
        Pose here = new Pose(
                place.get(0).number(),
                place.get(1).number(),
                withHeading ? place.get(2).number() : 0);
        motions.perform(motion, until -> new RequestedAction.GoTo(frame.atDesk(here), withHeading, until));
        return "";
    }

    private String hold() {
        motions.ask(new RequestedAction.Hold());
        return "held until free";
    }

    private String free() {
        motions.ask(new RequestedAction.Free());
        return "";
    }

    @Override
    protected void open() {
        try {
            PooledBroker broker = shared.brokers().acquire(address.broker(), this, environment);
            closeFeed();
            RobotFeed opening = new RobotFeed(broker, address, time(), new Events());
            feed = opening;
            commands = new RobotCommands(broker, address, opening, waiting);
            motions.reset();
            stop.reset();
            stopsAtDesk = NO_STOPS_KNOWN;
            delay.begin();
            opening.open();
            awaitRobot(opening);
        } catch (RuntimeException e) {
            release();
            throw e;
        }
    }

    /** Returns when everything has arrived that a connected robot has. */
    private void awaitRobot(RobotFeed opening) {
        if (waiting.awaitConnecting(opening::hasBegun, FIRST_SIGN_S)) {
            waiting.awaitConnecting(opening::isDecided, FIRST_STATE_S);
        }
        Description found = opening.description();
        RobotFeed.Received first = opening.state();
        if (found == null
                || first == null
                || opening.isOver()
                || first.state().link().connection() != Connection.CONNECTED) {
            throw new ConnectFailed(Reason.NO_ANSWER, Absence.of(address, opening));
        }
        adopt(found);
        report(first);
        frame.connected(first.state().motion());
        shared.brokers().stay(address.broker());
    }

    /** Takes the type, the parameters and the commands of the robot. */
    private void adopt(Description found) {
        Description before = description;
        if (before != null && !before.kind().type().equals(found.kind().type())) {
            throw new ConnectFailed(
                    Reason.WRONG_DEVICE,
                    address.desk() + " has another robot under this number now, a "
                            + found.kind().make() + "; remove this one and add it again");
        }
        description = found;
        type(new DescribedType(shared, found.kind(), address.desk()));
        profile(found.profile());
        described.describe(table(), found);
        commandNames.forEach(this::removeCommand);
        commandNames.clear();
        for (BotCommand command : found.commands()) {
            if (!command.name().equalsIgnoreCase(GOTO)) {
                commandNames.add(command.name());
                add(described.command(command));
            }
        }
    }

    @Override
    public String introduction() {
        Description known = description;
        return known == null ? super.introduction() : known.introduction() + " at " + address.desk();
    }

    /** Gives the robot back, so that others need not wait until the heartbeat is missed. */
    @Override
    protected void shut() {
        try {
            RobotFeed open = feed;
            if (open != null && !open.isOver() && open.holder().here()) {
                RobotCommands to = toDesk();
                to.forget(to.request(new RequestedAction.Free()));
            }
        } catch (BotException e) {
            LOG.log(Level.DEBUG, "could not give back " + name(), e);
        } finally {
            release();
        }
    }

    private void release() {
        closeFeed();
        shared.brokers().release(address.broker(), this);
    }

    private void closeFeed() {
        RobotFeed open = feed;
        if (open != null) {
            open.close();
        }
    }

    @Override
    protected Value moveBy(double mm, Motion motion) {
        Pose start = state().pose();
        RequestReply end = motions.perform(motion, until -> new RequestedAction.Move(mm, until));
        return covered(end).orElseGet(() -> Value.of(Math.copySign(start.distanceMm(state().pose()), mm), Unit.MM));
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        Pose start = state().pose();
        RequestReply end = motions.perform(motion, until -> new RequestedAction.Turn(degrees, until));
        return covered(end)
                .orElseGet(() -> Value.of(Pose.normalised(state().pose().headingDeg() - start.headingDeg()), Unit.DEG));
    }

    @Override
    protected @Nullable Value driveFor(double mmPerSec, double degPerSec, double seconds, Motion motion) {
        return covered(motions.perform(motion, until -> new RequestedAction.Drive(mmPerSec, degPerSec, seconds, until)))
                .orElse(null);
    }

    private static Optional<Value> covered(@Nullable RequestReply end) {
        return Optional.ofNullable(end).map(RequestReply::report).map(report -> report.amount());
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        RobotHolder holder = holder();
        if (holder.isElsewhere()) {
            throw new BotException(name() + " is held by " + holder.title());
        }
        motions.drive(mmPerSec, degPerSec);
    }

    @Override
    protected void halt() {
        motions.halt();
    }

    /** A robot that is closed is stopped only if this program may have moved it: others may be using it. */
    @Override
    protected void haltAhead() {
        if (connection() != Connection.CLOSED || motions.isActive()) {
            stop.sendAhead();
        }
    }

    @Override
    public void confirmHalt() {
        if (WaitPolicy.isAllowed()) {
            stop.confirm();
        }
    }

    /** Places the robot for all desks. */
    @Override
    protected void setPose(Pose pose) {
        motions.ask(new RequestedAction.Set(
                "pose",
                List.of(
                        Value.of(pose.xMm(), Unit.MM),
                        Value.of(pose.yMm(), Unit.MM),
                        Value.of(pose.headingDeg(), Unit.DEG))));
        frame.adopt(pose);
    }

    /** In the frame of its desk, as the desk knows it: the desk may follow the robot on a map. */
    @Override
    public Uncertainty uncertainty() {
        Uncertainty here = super.uncertainty();
        JsonNode there = values().get("placed");
        if (!here.isKnown() || !frame.isAdopted() || there == null) {
            return here;
        }
        return there.path(0).isNumber() && there.path(1).isNumber()
                ? Uncertainty.of(there.get(0).asDouble(), there.get(1).asDouble())
                : Uncertainty.UNKNOWN;
    }

    @Override
    public List<RangeSensor> rangeSensors() {
        Description known = description;
        return known == null ? List.of() : known.sensors();
    }

    /** Its desk keeps its place right. */
    @Override
    public Optional<Runnable> remoteLocalization() {
        return Optional.of(this::localize);
    }

    private void localize() {
        try {
            motions.ask(new RequestedAction.Localize());
        } catch (MotionFailed e) {
            throw new BotException("at " + address.desk() + ": " + e.getMessage(), e);
        }
        RobotFeed open = feed;
        RobotFeed.Received last = open == null ? null : open.state();
        if (last != null) {
            frame.adopt(last.state().motion().pose());
        }
    }

    private RobotCommands toDesk() {
        RobotCommands there = commands;
        if (there == null) {
            throw new BotException(name() + " is not connected");
        }
        return there;
    }

    private Map<String, JsonNode> values() {
        RobotFeed open = feed;
        RobotFeed.Received last = open == null ? null : open.state();
        return last == null ? Map.of() : last.state().values();
    }

    /** Also while the robot is being connected. */
    private boolean isFeeding() {
        RobotFeed open = feed;
        return open != null && !open.isOver();
    }

    private RobotHolder holder() {
        RobotFeed open = feed;
        return open == null ? new RobotHolder(null, false) : open.holder();
    }

    /** Publishes what the desk has reported. */
    private void report(RobotFeed.Received received) {
        RobotState.Movement motion = received.state().motion();
        if (received.state().values().get("maxMove") instanceof NumericNode most && most.doubleValue() > 0) {
            maxMove(most.doubleValue());
        }
        publish(new BotState(
                motion.pose().seenFrom(motion.origin()),
                motion.mmPerSec(),
                motion.degPerSec(),
                motion.moving(),
                received.reportedNanos() - delay.oneWayNanos()));
        frame.reported(motion);
        noteStops(received.state().stops());
    }

    /**
     * A stop by another program or at the desk ends what this program does with the robot, so that it does not go on
     * after the stop.
     */
    private void noteStops(long now) {
        long before = stopsAtDesk;
        stopsAtDesk = now;
        if (before != NO_STOPS_KNOWN && now > before && !stop.isPending()) {
            membership().ifPresentOrElse(TeamMembership::stoppedElsewhere, this::revokeMotions);
            changes().raise();
        }
    }

    /**
     * Runs a few times a second: notices silence, keeps the hold, measures the delay, takes over a new description,
     * asks for scans.
     */
    private void tick() {
        RobotFeed open = feed;
        if (open == null || !isConnected()) {
            return;
        }
        if (open.silenceS() > SILENCE_S) {
            loseBecause("nothing has arrived from " + address.desk() + " for " + Math.round(SILENCE_S) + " s");
            return;
        }
        if (open.holder().here() || motions.isActive()) {
            toDesk().heartbeat(this::heartbeatRefused);
        }
        Description newest = open.description();
        if (newest != null && !newest.equals(description)) {
            readopt(newest);
        }
        if (hasScanListeners() && !rangeSensors().isEmpty()) {
            toDesk().keepScans();
        }
        String warning = delay.tick();
        if (warning != null) {
            notice(warning);
        }
        long leftOut = open.linesLeftOut();
        if (leftOut > 0) {
            notice(leftOut + (leftOut == 1 ? " line" : " lines") + " of " + address.desk()
                    + " left out: more arrive than can be read");
        }
    }

    private void heartbeatRefused(PublicationRefused refused) {
        environment
                .time()
                .runAsync(
                        "heartbeat refused",
                        () -> notice(address.desk() + " stops it within a second of each motion: the broker refuses"
                                + " the heartbeats of its holder (" + refused.reason() + ")"));
    }

    private void readopt(Description newest) {
        try {
            adopt(newest);
            news();
        } catch (ConnectFailed e) {
            loseBecause(String.valueOf(e.getMessage()));
        }
    }

    private void loseBecause(String reason) {
        lost(new LinkLost(reason));
        changes().raise();
    }

    @Override
    public Optional<String> remoteHolder() {
        RobotHolder holder = holder();
        return isConnected() && holder.isElsewhere() ? Optional.of(holder.title()) : Optional.empty();
    }

    @Override
    public JComponent display() {
        return SharedPanel.create(this, this::scene, this::requestPicture);
    }

    @Override
    public Map<String, String> displayState() {
        return SharedReplay.texts(scene());
    }

    @Override
    public boolean hasCamera() {
        Description known = description;
        return known != null && known.camera();
    }

    @Override
    public byte[] takePicture() {
        return hasCamera() ? motions.picture() : super.takePicture();
    }

    private SharedScene scene() {
        RobotHolder holder = holder();
        return new SharedScene(
                address.toString(), holder.title(), holder.here(), delay.delay().toString(), hasCamera());
    }

    /** Asks for a picture of the camera, and publishes it when it arrives. Blocks; not for the event thread. */
    private byte[] requestPicture() {
        byte[] jpeg = motions.picture();
        publishPicture(() -> jpeg);
        return jpeg;
    }

    /** The robot as its motions see it. */
    private final class AtDesk implements RemoteMotions.Remote {
        @Override
        public String desk() {
            return address.desk();
        }

        @Override
        public boolean canGuard(String until) {
            return !ONLY_HERE.matcher(until).find() && frame.hasMeaningOf(until);
        }

        @Override
        public boolean isMoving() {
            return state().moving();
        }
    }

    /** Handles what arrives, on the thread of the broker's connection. */
    private final class Events implements RobotFeed.Listener {
        @Override
        public void described(Description found) {
            changes().raise();
        }

        @Override
        public void presenceKnown() {
            changes().raise();
        }

        @Override
        public void reported(RobotFeed.Received received) {
            report(received);
            RobotState.Link link = received.state().link();
            if (isConnected() && link.connection() != Connection.CONNECTED) {
                loseBecause(address.desk() + " has lost its connection to the robot" + link.because());
            }
        }

        @Override
        public void scanned(ScanMessage scan, long nanos, double sinceS) {
            double ageS = sinceS + delay.oneWayNanos() / 1e9;
            if (isConnected() && ageS <= OLDEST_SCAN_S) {
                rangeSensors().stream()
                        .filter(sensor -> sensor.name().equals(scan.sensor()))
                        .findFirst()
                        .ifPresent(sensor -> publishScan(scan.scan(sensor, nanos / 1e9 - ageS)));
            }
        }

        @Override
        public void message(RobotMessage message) {
            RobotFeed open = feed;
            boolean shown = isConnected() && message.kind() != RobotMessage.Kind.ANSWER;
            if (shown && open != null && open.allowsLine()) {
                notice(message.text());
            }
        }

        @Override
        public void gone(String reason) {
            loseBecause(reason);
        }
    }
}
