package majic.aibo.session;

import java.util.function.Consumer;
import java.util.function.Supplier;
import majic.aibo.body.DogState;
import majic.aibo.body.Sensor;
import majic.aibo.urbi.AiboConnections;
import majic.aibo.urbi.DogClock;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.UrbiCommands;
import majic.aibo.urbi.UrbiMessage;
import majic.aibo.urbi.UrbiTransport;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.LinkLost;
import majic.driver.RobotWait;
import org.jspecify.annotations.Nullable;

/**
 * One connection to a dog, from connect to its end: creates the parts, connects them, and runs their periodic tasks.
 */
public final class AiboSession {
    private static final double FIRST_READINGS_S = 4;

    /** Receives the session's events. Called on reader and timer threads. */
    public interface Robot {
        /** A set of readings was received. */
        void sensed();

        /** Shows a message to the user. */
        void notice(String message);

        /** The connection was lost. Called once. */
        void lost(LinkLost cause);
    }

    private final RobotWait waiting;
    private final DogState dog;
    private final Robot robot;
    private final Tags tags = new Tags();
    private final SensorPolling polling;
    private final DogClock clock;
    private final BatteryWatch battery;
    private final MessageRouter router;
    private final AiboConnections connections;
    private final MotionExecutor executor;
    private final DogGuard guard;
    private final HeadSweep sweep;
    private final Microphone microphone;
    private final UrbiQuestions questions;
    private final PostureControl postures;
    private final JointControl joints;
    private final Walker walker;
    private final AiboDrive drive;
    private volatile @Nullable ConnectionMonitor monitor;

    /**
     * Creates a session; connects nothing and starts no thread.
     *
     * @param transport makes each of the connections to the dog
     * @param waiting of the driver
     * @param dog receives the readings
     * @param robot receives the events
     */
    public AiboSession(Supplier<UrbiTransport> transport, RobotWait waiting, DogState dog, Robot robot) {
        this.waiting = waiting;
        this.dog = dog;
        this.robot = robot;
        Consumer<String> notice = robot::notice;
        this.clock = new DogClock(waiting.time());
        this.battery = new BatteryWatch(notice);
        this.connections = new AiboConnections(transport, waiting, this::received, this::lost);
        this.polling = new SensorPolling(tags, connections.sensors(), clock);
        this.router = new MessageRouter(waiting.time(), dog, clock, battery, polling, robot::sensed);
        this.executor = new MotionExecutor(connections, tags, waiting, dog, robot::sensed);
        this.guard = new DogGuard(connections, tags, waiting, clock);
        this.sweep = new HeadSweep(connections.sensors(), tags);
        this.microphone = new Microphone(connections.sensors(), tags);
        this.questions = new UrbiQuestions(tags, waiting);
        this.postures = new PostureControl(executor, connections.motion(), questions, dog, notice);
        this.joints = new JointControl(executor, connections.sensors(), postures, sweep, dog);
        GaitControl gaits = new GaitControl(executor, guard, sweep, router, dog.senses());
        this.walker = new Walker(gaits, postures, dog, clock, waiting);
        this.drive = new AiboDrive(gaits, postures, dog, waiting.time(), notice);
    }

    /** Connects, sets up guard and readings; moves nothing. Leaves nothing open when it throws. */
    public void open() {
        connections.open();
        dog.forgetReadings();
        try {
            dog.takeStopCommands().ifPresent(connections.stop()::send);
            if (!guard.install()) {
                robot.notice(
                        "the dog takes no guard that would end its walk when the link is lost; its walks end within 2 s");
            }
            dog.legSpeed().look(connections.sensors(), tags);
            awaitFirstReadings();
            monitor = new ConnectionMonitor(connections, router, tags, waiting, clock);
            connections.announceOpened();
        } catch (BotException e) {
            connections.abort();
            throw e;
        }
    }

    private void awaitFirstReadings() {
        polling.begin();
        boolean all = waiting.awaitConnecting(() -> router.answered() == Sensor.values().length, FIRST_READINGS_S);
        if (!all && router.answered() == 0) {
            throw new ConnectFailed(
                    Reason.NO_ANSWER,
                    "the dog accepts the connection but sends no reading within " + (int) FIRST_READINGS_S
                            + " s; restart the dog");
        }
        router.restartSilence();
    }

    public AiboConnections connections() {
        return connections;
    }

    public MotionExecutor executor() {
        return executor;
    }

    public DogGuard guard() {
        return guard;
    }

    public HeadSweep sweep() {
        return sweep;
    }

    public Microphone microphone() {
        return microphone;
    }

    public PostureControl postures() {
        return postures;
    }

    public JointControl joints() {
        return joints;
    }

    public Walker walker() {
        return walker;
    }

    public AiboDrive drive() {
        return drive;
    }

    public UrbiQuestions questions() {
        return questions;
    }

    /**
     * Passes all messages that are neither a reading nor an answer to a listener on the reader threads, until the
     * result is run.
     */
    public Runnable listen(Consumer<UrbiMessage> listener) {
        return router.listen(listener);
    }

    /** Sends the stop for everything that moves. */
    public void halt() {
        drive.forget();
        executor.halt(sweep.halt());
    }

    /**
     * Sends that stop on the stop connection while a command may be stuck on another. The sweep still counts as
     * running, because the command that begins it may not have arrived yet.
     */
    public void haltAhead() {
        drive.forget();
        executor.halt(sweep.stopCommand());
    }

    /** Runs the periodic tasks; called ten times a second by the robot's timer thread. */
    public void tick() {
        ConnectionMonitor current = monitor;
        if (current != null) {
            current.tick();
            haltInSilence(current);
            polling.tick(executor.current() != null);
        }
        executor.repeatStop();
        drive.tick();
        guard.tick(executor.current());
        sweep.tick();
    }

    private void haltInSilence(ConnectionMonitor current) {
        String silence = current.fallsSilent();
        if (silence != null && executor.current() != null) {
            robot.notice(silence + "; it moves, so MAJIC stops it");
            executor.halt(sweep.halt());
            waiting.changes().raise();
        }
    }

    /** Stops the dog, ends its polling, and closes the connections. */
    public void close() {
        drive.forget();
        connections.close(closingCommands() + dog.legSpeed().restore());
    }

    /** The commands that end everything the dog does for this session. */
    private String closingCommands() {
        RunningMotion running = executor.current();
        String own = running == null ? "" : " " + running.stopCommands();
        return UrbiCommands.STOP_GAITS + own + sweep.halt() + " " + guard.stop() + " " + polling.stop()
                + microphone.stopCommand() + " ";
    }

    private void received(UrbiMessage message) {
        if (!microphone.take(message)) {
            router.received(message);
        }
    }

    private void lost(LinkLost cause) {
        drive.forget();
        if (executor.current() != null || sweep.isSweeping()) {
            dog.keepStopCommands(closingCommands());
        }
        robot.lost(battery.explained(cause));
        executor.abandon();
    }
}
