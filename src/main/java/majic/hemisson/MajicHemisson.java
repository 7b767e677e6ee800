package majic.hemisson;

import java.util.function.BooleanSupplier;
import javax.swing.JComponent;
import majic.bot.BotAddress;
import majic.bot.BotEnvironment;
import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.bot.BotState;
import majic.bot.CalibrateCommand;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.Motion;
import majic.bot.MotionFailed;
import majic.bot.MotionStopped;
import majic.bot.Pose;
import majic.bot.Range;
import majic.bot.Value;

/**
 * A K-Team Hemisson. It has neither encoders nor a watchdog: motions are timed, positions are estimates, and a robot
 * whose link is lost keeps driving. Therefore it is asked something all the while it moves, told to stand again and
 * again from the first missed answer, and told to stand at every close.
 *
 * <p>Conventions as in {@link MajicBot}; safe from any thread.
 */
public final class MajicHemisson extends MajicBot {
    /** What a person can do about a robot that moves and does not hear. */
    static final String HELP = "if it still moves, lift it, or press 5 on a TV remote control";

    private static final double CRUISE_MM_PER_S = 42;
    private static final double CRUISE_TURN_DEG_PER_S = 53;
    private static final double NEAR_MM = 40;

    /** The longest wait for an answer: two tries over Bluetooth, and somebody else's before it, seconds. */
    private static final double LONGEST_ANSWER_S = 4;

    /** How often overdue answers are looked for, and how often a moving robot is asked what it sees, seconds. */
    private static final double TICK_S = 0.05;

    private final Calibration calibration;
    private final Sessions sessions;
    private final Overseer overseer;
    private final Lamps lamps = new Lamps(this);
    private final Spectator spectator = new Spectator(this);
    private final Access access = new Access(this);
    private volatile Identity identity = Identity.NOBODY;
    private volatile Modules modules = Modules.NONE;

    /**
     * Makes a driver that lives by the system's clock and remembers nothing.
     *
     * @param address as a user types it: {@code hemisson:/dev/ttyUSB0}, {@code hemisson://host:port}
     * @throws BotException if the address is none
     */
    public MajicHemisson(String address) {
        this(BotAddress.parse(address).rest(), BotEnvironment.plain());
    }

    /**
     * Makes a driver, without touching the robot.
     *
     * @param address the name of a serial port, {@code tcp://host:port} or {@code //host:port}
     * @param environment its clock, and the settings its calibration is kept in
     * @throws BotException if the address is none; the message says what one looks like
     */
    public MajicHemisson(String address, BotEnvironment environment) {
        super(new HemissonType(), profileFor(SpeedTable.USUAL), environment);
        this.sessions = new Sessions(address, time(), changes());
        this.calibration = new Calibration(settings(), address);
        this.overseer = new Overseer(this, Track.standing(Pose.START, nanos(), calibration.table()));
        profile(profileFor(calibration.table()));
        HemissonParameters.describe(table(), access);
        add(CalibrateCommand.of(new Lesson(this)));
        new I2cCommands(access).all().forEach(this::add);
    }

    private static BotProfile profileFor(SpeedTable table) {
        double fastest = table.fastestMmPerSec();
        double fastestSpin = table.spinDegPerSec(Wheels.MAX);
        return new BotProfile(
                Clearance.HULL_MM,
                new Range(-fastest, fastest),
                new Range(-fastestSpin, fastestSpin),
                table.mmPerSec(SpeedTable.SLOWEST),
                table.spinDegPerSec(SpeedTable.SLOWEST),
                CRUISE_MM_PER_S,
                CRUISE_TURN_DEG_PER_S,
                NEAR_MM,
                true);
    }

    @Override
    protected void open() {
        Session opened = sessions.open(overseer);
        overseer.begin(opened);
        opened.start();
        every("hemisson line", TICK_S, overseer::tick);
        try {
            Handshake handshake = new Handshake(opened, changes());
            identity = handshake.run();
            equip(handshake.scan());
        } catch (BotException e) {
            sessions.end();
            throw e;
        }
        overseer.watch();
        recognise(identity);
    }

    /** Takes over what is plugged in. */
    void equip(Modules found) {
        modules = found;
        table().renew(fresh -> found.describe(fresh, access));
        Modules.COMMANDS.forEach(this::removeCommand);
        found.commands(access).forEach(this::add);
    }

    /** Takes over who answers, and warns if it runs in a mode of its own. */
    void recognise(Identity found) {
        identity = found;
        String warning = found.warning();
        if (warning != null) {
            notice(warning);
        }
    }

    @Override
    protected void shut() {
        Session open = sessions.current();
        if (open != null && !Farewell.say(open, changes())) {
            say("it has not confirmed that it stands; " + HELP);
        }
        sessions.end();
    }

    @Override
    protected Value moveBy(double mm, Motion motion) {
        return new OpenLoop(this, motion).run(Leg.straight(mm, cruiseMmPerSec(), calibration.table()));
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        return new OpenLoop(this, motion).run(Leg.spin(degrees, cruiseTurnDegPerSec(), calibration.table()));
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        overseer.motion().drives(nanos());
        Wheels wheels = calibration.table().curve(mmPerSec, degPerSec);
        String failure = conversation().ask(Question.wheels(wheels)).failure();
        if (failure != null) {
            throw new MotionFailed(failure);
        }
    }

    @Override
    protected void halt() {
        Session open = sessions.current();
        if (open != null) {
            open.conversation().stop();
        }
    }

    @Override
    protected void confirmHalt() {
        Session open = sessions.current();
        if (open == null) {
            return;
        }
        double patience = 2 * open.timeoutSeconds() + 0.9;
        try {
            changes().await(() -> open.conversation().isStanding() || !isConnected(), patience);
            if (!open.conversation().isStanding()) {
                throw isConnected()
                        ? new BotException("the stop was not confirmed within " + patience + " s; " + HELP)
                        : new LinkLost("the connection was lost before the stop was confirmed; " + HELP);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public JComponent display() {
        return HemissonPanel.create(this);
    }

    /** The conversation with the robot, if there is one. */
    Conversation conversation() {
        return sessions.conversation();
    }

    /** Asks one question and waits for the answer, whoever else talks. */
    Reply ask(Question question) {
        Exchange exchange = conversation().ask(question);
        await(exchange::isDone);
        Reply reply = exchange.reply();
        if (reply == null) {
            String failure = exchange.failure();
            throw new BotException(failure == null ? "no answer" : failure);
        }
        return reply;
    }

    /** Waits for what an answer brings, as long as one may take with its repetition and others before it. */
    void await(BooleanSupplier condition) {
        try {
            changes().await(() -> condition.getAsBoolean() || !isConnected(), LONGEST_ANSWER_S);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new MotionStopped("interrupted");
        }
    }

    /** Lets time pass, unless the connection is lost. */
    void pause(double seconds) {
        try {
            changes().await(() -> !isConnected(), seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new MotionStopped("interrupted");
        }
    }

    long nanos() {
        return time().nanos();
    }

    boolean isLost() {
        return connection() == Connection.LOST;
    }

    void raise() {
        changes().raise();
    }

    void say(String message) {
        notice(message);
    }

    void lose(LinkLost cause) {
        lost(cause);
    }

    void publishTrack(Track track) {
        long now = nanos();
        publish(new BotState(
                track.at(now),
                track.speedMmPerSec(),
                track.turnDegPerSec(),
                !track.wheels().isStill(),
                now));
    }

    Overseer overseer() {
        return overseer;
    }

    Lamps lamps() {
        return lamps;
    }

    Spectator spectator() {
        return spectator;
    }

    Identity identity() {
        return identity;
    }

    SpeedTable speeds() {
        return calibration.table();
    }

    /** Takes over and keeps another calibration, for all motions from the next one on; holds even where it could not be kept. */
    void learn(SpeedTable better) {
        try {
            calibration.learn(better);
        } finally {
            overseer.use(better);
            profile(profileFor(better));
        }
    }

    Modules modules() {
        return modules;
    }

    double cruise() {
        return cruiseMmPerSec();
    }

    double cruiseTurn() {
        return cruiseTurnDegPerSec();
    }

    /** Begins something that waits for the robot, on a thread of its own. */
    void aside(String what, Runnable task) {
        time().thread(name() + ": " + what, task).start();
    }

    /** Whether its wheels may turn though nobody can tell it anything: the link is lost, or it misses answers. */
    boolean isOutOfControl() {
        Session open = sessions.current();
        return open != null
                && (open.conversation().isUnreached()
                        || (isLost() && open.conversation().mayMove()));
    }

    /** How long no question has been answered, seconds; 0 while none can be asked. */
    double silentSeconds() {
        Session open = sessions.current();
        return open == null || !isConnected() ? 0 : open.conversation().silentSeconds();
    }

    /** How well the line works; nothing counted while there is none. */
    LinkQuality quality() {
        return sessions.quality();
    }
}
