package majic.hemisson;

import javax.swing.JComponent;
import majic.bot.BotAddress;
import majic.bot.BotEnvironment;
import majic.bot.BotException;
import majic.bot.BotState;
import majic.bot.CalibrateCommand;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.Motion;
import majic.bot.MotionFailed;
import majic.bot.Value;
import org.jspecify.annotations.Nullable;

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

    /** How often overdue answers are looked for, and how often a moving robot is asked what it sees, seconds. */
    private static final double TICK_S = 0.05;

    private final Calibration calibration;
    private final Sessions sessions;
    private final Answers answers;
    private final Standstill standstill;
    private final Overseer overseer;
    private final Lamps lamps = new Lamps(this);
    private final Pins pins = new Pins();
    private final Spectator spectator = new Spectator(this);
    private final Access access = new Access(this);
    private volatile Identity identity = Identity.NOBODY;
    private volatile Modules modules = Modules.NONE;
    private volatile Wheels driven = Wheels.STILL;

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
        super(new HemissonType(), HemissonProfile.of(SpeedTable.USUAL), environment);
        this.sessions = new Sessions(address, time());
        this.answers = new Answers(sessions, changes(), this::isConnected);
        this.standstill = new Standstill(sessions, changes(), this::isLost, this::contrary);
        this.calibration = new Calibration(settings(), address);
        this.overseer = new Overseer(this, calibration.table());
        profile(HemissonProfile.of(calibration.table()));
        HemissonParameters.describe(table(), access);
        add(CalibrateCommand.of(new Lesson(this)));
        new I2cCommands(access).all().forEach(this::add);
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
        String unsettled = standstill.end();
        if (unsettled != null) {
            say(unsettled);
        }
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
        refuseContrary();
        overseer.motion().drives(nanos());
        driven = calibration.table().curve(mmPerSec, degPerSec);
        String failure = conversation().ask(Question.wheels(driven)).failure();
        if (failure != null) {
            throw new MotionFailed(failure);
        }
    }

    /** Motors take whole values, so it is seldom quite what was wanted. */
    @Override
    protected Value driven() {
        return Value.text(calibration.table().words(driven));
    }

    @Override
    protected void halt() {
        standstill.order();
    }

    @Override
    protected void confirmHalt() {
        standstill.confirm();
    }

    @Override
    public JComponent display() {
        return HemissonPanel.create(this);
    }

    /** The conversation with the robot, if there is one. */
    Conversation conversation() {
        return sessions.conversation();
    }

    /** Who waits for its answers. */
    Answers answers() {
        return answers;
    }

    Sessions sessions() {
        return sessions;
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

    void tell(BotState state) {
        publish(state);
    }

    /** Begins no motion of a robot that has set its own speeds in place of a stop. */
    void refuseContrary() {
        String found = contrary();
        if (found != null && conversation().isContrary()) {
            throw new MotionFailed(found);
        }
    }

    private @Nullable String contrary() {
        return overseer.wheels().found();
    }

    Overseer overseer() {
        return overseer;
    }

    Pins pins() {
        return pins;
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
            overseer.reckoning().use(better);
            profile(HemissonProfile.of(better));
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
}
