package majic.aibo;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.Motion;
import majic.bot.MotionFailed;
import majic.link.Link;
import org.jspecify.annotations.Nullable;

/** Everything that lives from one connect to the end of the connection. */
final class AiboSession {
    private static final Logger LOG = System.getLogger(AiboSession.class.getName());
    private static final Pattern BATTERY = Pattern.compile("Battery at (\\d{1,3}) ?%.*");
    private static final double FIRST_READINGS_S = 4;
    private static final double FREE_S = 3;
    private static final double SILENCE_S = 1.5;
    private static final double LOST_S = 4;

    /** What the session tells its robot. Called on reader and keeper threads. */
    interface Robot {
        /** A set of readings is in. */
        void sensed();

        /** Something worth saying. */
        void say(String message);

        /** It is over. */
        void lost(LinkLost cause);
    }

    private final Watch watch;
    private final Dog dog;
    private final Robot robot;
    private final List<Consumer<UrbiMessage>> hearers = new CopyOnWriteArrayList<>();
    private final Tags tags = new Tags();
    private final Poll poll = new Poll(tags);
    private final AiboLinks links;
    private final Runner runner;
    private final DogGuard guard;
    private final HeadSweep sweep;
    private final Microphone microphone;
    private final Feet feet;
    private final Driving driving;
    private final BatteryWatch battery;
    private final Map<UrbiConnection, Pulse> pulses = new LinkedHashMap<>();
    private volatile long lastWordNanos;
    private volatile boolean silent;

    AiboSession(Supplier<Link> link, Watch watch, Dog dog, Robot robot) {
        this.watch = watch;
        this.dog = dog;
        this.robot = robot;
        this.links = new AiboLinks(link, watch, this::heard, this::lost);
        this.runner = new Runner(links, tags, watch, dog, robot::sensed);
        this.guard = new DogGuard(links, tags, watch);
        this.sweep = new HeadSweep(links.sensors(), tags);
        this.microphone = new Microphone(links.sensors(), tags);
        Consumer<String> notice = robot::say;
        this.feet = new Feet(this, dog, notice);
        this.driving = new Driving(this, notice);
        this.battery = new BatteryWatch(notice);
    }

    /** Connects, sets up guard and readings; moves nothing. Leaves nothing open when it throws. */
    void open() {
        links.open();
        try {
            lastWordNanos = watch.time().nanos();
            guard.install();
            dog.legSpeed().look(links.sensors(), tags);
            for (Sensor.Rate rate : Sensor.Rate.values()) {
                links.sensors().send(poll.order(rate, links.sensors().dialect()));
            }
            boolean all = watch.await(() -> answered() == Sensor.values().length, FIRST_READINGS_S);
            if (!all && answered() == 0) {
                throw new BotException("the dog lets itself be connected but tells no reading within "
                        + (int) FIRST_READINGS_S + " s; restart the dog");
            }
            lastWordNanos = watch.time().nanos();
            for (UrbiConnection quiet : List.of(links.motion(), links.stop())) {
                pulses.put(quiet, new Pulse(quiet, tags, watch));
            }
            links.announceOpened();
        } catch (BotException e) {
            links.abort();
            throw e;
        }
    }

    private long answered() {
        return Arrays.stream(Sensor.values()).filter(dog.senses()::isAnswered).count();
    }

    Watch watch() {
        return watch;
    }

    AiboLinks links() {
        return links;
    }

    Runner runner() {
        return runner;
    }

    DogGuard guard() {
        return guard;
    }

    HeadSweep sweep() {
        return sweep;
    }

    Microphone microphone() {
        return microphone;
    }

    Feet feet() {
        return feet;
    }

    Driving driving() {
        return driving;
    }

    Dog dog() {
        return dog;
    }

    /** Whether the dog has said nothing for so long that it must not move. */
    boolean isSilent() {
        return watch.time().secondsSince(lastWordNanos) > SILENCE_S;
    }

    /** Says something to the person. */
    void say(String message) {
        robot.say(message);
    }

    /** Asks for a value. */
    UrbiValue ask(UrbiConnection on, String expression, double seconds) {
        Ask ask = new Ask(tags.next(), Ask.Expects.VALUE);
        on.send(ask, on.dialect().labelled(ask.tag(), expression) + ";");
        watch.await(() -> ask.isDone() || on.isEnded(), seconds);
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
    void awaitFree(Motion motion) {
        motion.check();
        if (!watch.await(() -> runner.current() == null, FREE_S)) {
            throw new MotionFailed("the dog has not ended what it did before");
        }
        motion.check();
    }

    /** Sends the stop for everything that moves. */
    void halt() {
        driving.forget();
        runner.halt(sweep.halt());
    }

    /**
     * Sends that stop on the stop connection while a command may be stuck on another. The sweep is not taken for ended,
     * for a command that begins it may be on its way.
     */
    void haltAhead() {
        driving.forget();
        runner.halt(sweep.stopCommand());
    }

    /** The duties that come round ten times a second, on the keeper's thread. */
    void tend() {
        tendSilence();
        tendPulses();
        runner.pursue();
        driving.tend();
        Running running = runner.current();
        guard.tend(running != null && running.piece() != null && !running.isStopRequested());
        sweep.tend();
    }

    private void tendSilence() {
        double seconds = watch.time().secondsSince(lastWordNanos);
        if (seconds > LOST_S) {
            links.broken(links.sensors(), "no word from the dog for " + (int) LOST_S + " s");
        } else if (isSilent() && !silent && runner.current() != null) {
            silent = true;
            robot.say("no word from the dog for " + SILENCE_S + " s while it moves: it is told to stop");
            halt();
            watch.changes().raise();
        }
    }

    private void tendPulses() {
        pulses.forEach((connection, pulse) -> {
            if (!pulse.beats()) {
                links.broken(connection, Pulse.silence());
            }
        });
    }

    /** Stops, says goodbye, closes. */
    void close() {
        driving.forget();
        links.close(Runner.STOP_GAITS + own(runner.current()) + sweep.halt() + " " + guard.stop() + " " + poll.stop()
                + microphone.stopCommand() + " " + dog.legSpeed().restore());
    }

    private static String own(@Nullable Running running) {
        return running == null ? "" : " " + running.stopCommands();
    }

    private void lost(LinkLost cause) {
        driving.forget();
        robot.lost(battery.explained(cause));
        runner.abandon();
    }

    private void heard(UrbiMessage message) {
        Sensor sensor = poll.sensor(message);
        if (sensor != null) {
            sensed(sensor, message);
        } else if (message.tag().equals("power") && message.body() instanceof UrbiMessage.Info info) {
            heardPower(info.text());
        } else if (!microphone.hears(message)) {
            LOG.log(Level.TRACE, "unasked: {0}", message);
            hearers.forEach(hearer -> hearer.accept(message));
        }
    }

    /** Has somebody hear, on the readers' threads, all that is neither a reading nor an answer; what it returns ends it. */
    Runnable listen(Consumer<UrbiMessage> hearer) {
        hearers.add(hearer);
        return () -> hearers.remove(hearer);
    }

    private void heardPower(String text) {
        Matcher words = BATTERY.matcher(text);
        if (words.matches()) {
            sensed(Sensor.CHARGE, new UrbiValue.Num(Integer.parseInt(words.group(1)) / 100.0));
        }
    }

    private void sensed(Sensor sensor, UrbiMessage message) {
        lastWordNanos = watch.time().nanos();
        silent = false;
        if (message.body() instanceof UrbiMessage.Result result) {
            sensed(sensor, result.value());
        } else if (message.body() instanceof UrbiMessage.Failure failure) {
            dog.senses().refuse(sensor, "the dog says: " + failure.text());
        }
        if (sensor == Sensor.HEAD_PAN) {
            dog.sensed(message.timeMs());
            robot.sensed();
        }
    }

    private void sensed(Sensor sensor, UrbiValue value) {
        dog.senses().put(sensor, value);
        if (sensor == Sensor.CHARGE) {
            dog.senses().number(sensor).ifPresent(battery::heard);
        }
    }
}
