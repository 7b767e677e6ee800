package majic.hemisson;

import java.util.List;
import java.util.Map;
import javax.swing.JComponent;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotState;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.Value;
import majic.driver.BotDriver;
import majic.driver.CalibrateCommand;
import majic.driver.Motion;
import majic.environment.BotEnvironment;
import majic.hemisson.line.BlockingConversation;
import majic.hemisson.line.CurrentSession;
import majic.hemisson.line.Handshake;
import majic.hemisson.line.HemissonSession;
import majic.hemisson.line.Reply;
import majic.hemisson.line.StopConfirmation;
import majic.hemisson.modules.I2cCommands;
import majic.hemisson.modules.Modules;
import majic.hemisson.motion.MotionRunner;
import majic.hemisson.motion.RobotMonitor;
import majic.hemisson.motion.SpeedCalibration;
import majic.hemisson.motion.SpeedCalibrationRun;
import majic.hemisson.motion.SpeedTable;
import majic.hemisson.motion.TimedMotion;
import majic.hemisson.panel.HemissonPanel;
import majic.hemisson.panel.HemissonReplay;
import majic.hemisson.parameters.HemissonParameters;
import majic.hemisson.parameters.LedsAndBuzzer;
import majic.hemisson.parameters.Pins;
import majic.hemisson.readings.RobotReadings;

/**
 * A K-Team Hemisson. It has neither encoders nor a watchdog: motions are timed, positions are estimates, and a robot
 * whose connection is lost keeps driving. Therefore it is polled all the time while it moves, and the stop is repeated
 * from the first missed answer until it is confirmed, and at every close.
 *
 * <p>Conventions as in {@link MajicBot}; safe from any thread.
 */
public final class MajicHemisson extends BotDriver {
    /** How often overdue answers are checked, and a moving robot is polled, seconds. */
    private static final double TICK_S = 0.05;

    private final Pins pins = new Pins();
    private final CurrentSession sessions;
    private final RobotMonitor monitor;
    private final SpeedCalibration calibration;
    private final StopConfirmation stopConfirmation;
    private final RobotReadings readings;
    private final MotionRunner motions;
    private final LedsAndBuzzer leds;
    private final HemissonScenes scenes;
    private final HemissonParameters parameters;

    /**
     * Creates a driver with the system's clock and without settings.
     *
     * @param address as a user types it: {@code hemisson:/dev/ttyUSB0}, {@code hemisson://host:port}
     * @throws BotException if the address is not valid
     */
    public MajicHemisson(String address) {
        this(BotAddress.parse(address), BotEnvironment.plain());
    }

    /**
     * Creates a driver; sends nothing to the robot.
     *
     * @param address of the type {@code hemisson}; behind the colon the name of a serial port, {@code tcp://host:port}
     *     or {@code //host:port}
     * @param environment its clock, and the settings that keep its calibration
     * @throws BotException if the address is not valid; the message shows the valid forms
     */
    public MajicHemisson(BotAddress address, BotEnvironment environment) {
        this(place(address), environment);
    }

    private MajicHemisson(String address, BotEnvironment environment) {
        super(new HemissonType(), HemissonProfile.of(SpeedTable.USUAL), environment);
        this.sessions = new CurrentSession(address, time());
        this.calibration = new SpeedCalibration(settings(), address, this::use);
        this.monitor = new RobotMonitor(new Owner(), time(), changes(), calibration.table());
        BlockingConversation answers = new BlockingConversation(sessions, waiting(), this::isConnected);
        this.stopConfirmation = new StopConfirmation(sessions, waiting(), this::isLost, monitor.wheels()::found);
        this.motions = new MotionRunner(sessions, answers, stopConfirmation, monitor, time());
        this.readings = new RobotReadings(monitor.polled(), answers, time());
        this.leds = new LedsAndBuzzer(answers);
        this.scenes = new HemissonScenes(this, sessions, monitor, leds);
        profile(HemissonProfile.of(calibration.table()));
        this.parameters = new HemissonParameters(
                table(), readings, leds, pins, calibration, monitor::identity, sessions::quality);
        parameters.describe(Modules.NONE);
        add(CalibrateCommand.of(new SpeedCalibrationRun(calibration, motions, new Cruise())));
        new I2cCommands(readings).all().forEach(this::add);
    }

    private static String place(BotAddress address) {
        if (!address.type().equals("hemisson")) {
            throw new BotException(
                    address + ": not a Hemisson's address; it looks like hemisson:COM3 or hemisson://host:port");
        }
        address.libraryAmong(List.of());
        return address.rest();
    }

    private void use(SpeedTable better) {
        monitor.pose().use(better);
        profile(HemissonProfile.of(better));
    }

    @Override
    protected void open() {
        HemissonSession opened = sessions.open(monitor);
        calibration.belongsTo(sessions.names());
        monitor.begin(opened);
        opened.start();
        every("hemisson line", TICK_S, monitor::tick);
        try {
            Handshake handshake = new Handshake(opened, waiting());
            monitor.identified(handshake.run());
            Reply scan = handshake.scan();
            equip(scan == null ? Modules.NONE : Modules.of(scan));
        } catch (BotException e) {
            sessions.end();
            throw e;
        }
        monitor.watch();
    }

    /** Describes the parameters and adds the commands of a robot with these modules. */
    void equip(Modules found) {
        parameters.describe(found);
        Modules.COMMANDS.forEach(this::removeCommand);
        found.commands(readings).forEach(this::add);
    }

    @Override
    protected void shut() {
        String unsettled = stopConfirmation.end();
        if (unsettled != null) {
            notice(unsettled);
        }
    }

    @Override
    protected Value moveBy(double mm, Motion motion) {
        return motions.run(TimedMotion.straight(mm, cruiseMmPerSec(), calibration.table()), motion);
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        return motions.run(TimedMotion.spin(degrees, cruiseTurnDegPerSec(), calibration.table()), motion);
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        motions.drive(calibration.table().curve(mmPerSec, degPerSec));
    }

    /** Motor values are whole numbers, so speeds are seldom exactly those requested. */
    @Override
    protected Value driven() {
        return Value.text(calibration.table().words(motions.driven()));
    }

    @Override
    protected void halt() {
        stopConfirmation.send();
    }

    @Override
    public void confirmHalt() {
        stopConfirmation.confirm();
    }

    @Override
    public List<String> calibration() {
        return HemissonParameters.CALIBRATION;
    }

    @Override
    public JComponent display() {
        return HemissonPanel.create(
                this,
                scenes::now,
                task -> time().thread(name() + ": leds", task).start());
    }

    @Override
    protected double longestAgeS() {
        return LONGEST_AGE_S;
    }

    @Override
    public Map<String, String> displayState() {
        return HemissonReplay.texts(scenes.now());
    }

    private boolean isLost() {
        return connection() == Connection.LOST;
    }

    /** What the monitor needs of this driver. */
    private final class Owner implements RobotMonitor.Owner {
        @Override
        public boolean isConnected() {
            return MajicHemisson.this.isConnected();
        }

        @Override
        public boolean isLost() {
            return MajicHemisson.this.isLost();
        }

        @Override
        public void publish(BotState state) {
            MajicHemisson.this.publish(state);
        }

        @Override
        public void wasReset() {
            leds.forget();
            pins.forget();
        }

        @Override
        public void notice(String message) {
            MajicHemisson.this.notice(message);
        }

        @Override
        public void lose(LinkLost cause) {
            lost(cause);
        }
    }

    /** The usual speeds, which are the ones to calibrate. */
    private final class Cruise implements SpeedCalibrationRun.Pace {
        @Override
        public double mmPerSec() {
            return cruiseMmPerSec();
        }

        @Override
        public double degPerSec() {
            return cruiseTurnDegPerSec();
        }
    }
}
