package majic.aibo.session;

import java.util.function.Consumer;
import java.util.function.Supplier;
import majic.aibo.body.DogState;
import majic.aibo.body.Sensor;
import majic.aibo.urbi.AiboConnections;
import majic.aibo.urbi.DogClock;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.UrbiCommands;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiMessage;
import majic.aibo.urbi.UrbiRefusal;
import majic.aibo.urbi.UrbiRequest;
import majic.aibo.urbi.UrbiValue;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.Motion;
import majic.bot.MotionFailed;
import majic.driver.RobotWait;
import majic.link.Link;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/** Everything that lives from one connect to the end of the connection. */
public final class AiboSession {
    private static final double FIRST_READINGS_S = 4;

    /** As long as it takes to make sure that a stop has hit with an engine that is two seconds late. */
    private static final double FREE_S = 5;

    /** Receives the session's events. Called on reader and timer threads. */
    public interface Robot {
        /** A set of readings is in. */
        void sensed();

        /** Something worth saying. */
        void say(String message);

        /** It is over. */
        void lost(LinkLost cause);
    }

    private final RobotWait waiting;
    private final DogState dog;
    private final Robot robot;
    private final Tags tags = new Tags();
    private final PollCommands poll = new PollCommands(tags);
    private final DogClock clock;
    private final BatteryWatch battery;
    private final MessageRouter router;
    private final AiboConnections connections;
    private final MotionExecutor executor;
    private final DogGuard guard;
    private final HeadSweep sweep;
    private final Microphone microphone;
    private final PostureControl postures;
    private final AiboDrive driving;
    private volatile @Nullable ConnectionMonitor monitor;

    public AiboSession(Supplier<Link> link, RobotWait waiting, DogState dog, Robot robot) {
        this.waiting = waiting;
        this.dog = dog;
        this.robot = robot;
        Consumer<String> notice = robot::say;
        this.clock = new DogClock(waiting);
        this.battery = new BatteryWatch(notice);
        this.router = new MessageRouter(waiting, dog, poll, clock, battery, robot::sensed);
        this.connections = new AiboConnections(link, waiting, this::heard, this::lost);
        this.executor = new MotionExecutor(connections, tags, waiting, dog, robot::sensed);
        this.guard = new DogGuard(connections, tags, waiting, clock);
        this.sweep = new HeadSweep(connections.sensors(), tags);
        this.microphone = new Microphone(connections.sensors(), tags);
        this.postures = new PostureControl(this, dog, notice);
        this.driving = new AiboDrive(this, notice);
    }

    /** Connects, sets up guard and readings; moves nothing. Leaves nothing open when it throws. */
    public void open() {
        connections.open();
        try {
            dog.takeLeftovers().ifPresent(connections.stop()::send);
            if (!guard.install()) {
                robot.say(
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
        for (Sensor.Rate rate : Sensor.Rate.values()) {
            connections.sensors().send(poll.order(rate, connections.sensors().version()));
        }
        boolean all = waiting.awaitConnecting(() -> router.answered() == Sensor.values().length, FIRST_READINGS_S);
        if (!all && router.answered() == 0) {
            throw new BotException("the dog lets itself be connected but tells no reading within "
                    + (int) FIRST_READINGS_S + " s; restart the dog");
        }
        router.listenAnew();
    }

    public RobotWait waiting() {
        return waiting;
    }

    public AiboConnections connections() {
        return connections;
    }

    DogClock clock() {
        return clock;
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

    public AiboDrive driving() {
        return driving;
    }

    public DogState dog() {
        return dog;
    }

    /** Whether no reading has come for so long that the dog must not move. */
    boolean isSilent() {
        return router.silenceS() > ConnectionMonitor.SILENCE_S;
    }

    /** Shows a notice to the user. */
    public void say(String message) {
        robot.say(message);
    }

    /** Passes all that is neither a reading nor an answer to a listener on the readers' threads, until the result is run. */
    public Runnable listen(Consumer<UrbiMessage> hearer) {
        return router.listen(hearer);
    }

    /**
     * Asks for a value.
     *
     * @throws UrbiRefusal if the dog gives none, or the thread may not wait for it
     */
    public UrbiValue ask(UrbiConnection on, String expression, double seconds) {
        if (!WaitPolicy.isAllowed()) {
            throw new UrbiRefusal("the dog tells it only when asked");
        }
        UrbiRequest ask = on.ask(tags, expression);
        waiting.await(() -> ask.isDone() || on.isEnded(), seconds);
        on.forget(ask);
        UrbiValue value = ask.value();
        if (value == null) {
            String failure = ask.failure();
            throw new UrbiRefusal(
                    failure == null
                            ? "the dog did not answer within " + seconds + " s"
                            : "the dog refuses: " + failure);
        }
        return value;
    }

    /** Waits until the dog has ended what it did before this motion. */
    public void awaitFree(Motion motion) {
        motion.check();
        if (!waiting.await(() -> executor.current() == null, FREE_S)) {
            throw new MotionFailed("the dog has not ended what it did before");
        }
        motion.check();
    }

    /** Sends the stop for everything that moves. */
    public void halt() {
        driving.forget();
        executor.halt(sweep.halt());
    }

    /**
     * Sends that stop on the stop connection while a command may be stuck on another. The sweep is not taken for ended,
     * for a command that begins it may be on its way.
     */
    public void haltAhead() {
        driving.forget();
        executor.halt(sweep.stopCommand());
    }

    /** The duties that come round ten times a second, on the keeper's thread. */
    public void tend() {
        ConnectionMonitor watching = monitor;
        if (watching != null) {
            watching.tend();
            haltInSilence(watching);
        }
        executor.pursue();
        driving.tend();
        guard.tend(executor.current());
        sweep.tend();
    }

    private void haltInSilence(ConnectionMonitor watching) {
        if (watching.fallsSilent() && executor.current() != null) {
            robot.say("no word from the dog for " + ConnectionMonitor.SILENCE_S
                    + " s while it moves: it is told to stop");
            executor.halt(sweep.halt());
            waiting.changes().raise();
        }
    }

    /** Stops the dog, ends its polling, and closes the connections. */
    public void close() {
        driving.forget();
        connections.close(lastWords() + dog.legSpeed().restore());
    }

    /** What ends all that the dog does for this session. */
    private String lastWords() {
        RunningMotion running = executor.current();
        String own = running == null ? "" : " " + running.stopCommands();
        return UrbiCommands.STOP_GAITS + own + sweep.halt() + " " + guard.stop() + " " + poll.stop()
                + microphone.stopCommand() + " ";
    }

    private void heard(UrbiMessage message) {
        if (!microphone.hears(message)) {
            router.heard(message);
        }
    }

    private void lost(LinkLost cause) {
        driving.forget();
        if (executor.current() != null || sweep.isSweeping()) {
            dog.leave(lastWords());
        }
        robot.lost(battery.explained(cause));
        executor.abandon();
    }
}
