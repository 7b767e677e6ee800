package majicsim.pioneer.devices;

import java.util.List;
import majicsim.pioneer.model.Equipment;
import majicsim.pioneer.model.Setting;
import majicsim.pioneer.model.Settings;
import majicsim.world.Noise;

/** Everything on the robot besides motors, sonar and laser. A device that a model does not carry exists and is idle. */
public final class Devices {
    /** What controller, sonar and radio draw, and the motors at full speed on top. */
    private static final double IDLE_AMPERES = 0.9;

    private static final double DRIVING_AMPERES = 3;

    /** How much time may be let pass at once. */
    private static final long LONGEST_NANOS = 100_000_000;

    private final Settings settings = new Settings();
    private final UserPort userPort = new UserPort();
    private final Infrared infrared = new Infrared();
    private final StopButton stopButton = new StopButton(settings);
    private final Joystick joystick = new Joystick();
    private final Thermometer thermometer = new Thermometer();
    private final Buzzer buzzer = new Buzzer();
    private final Battery battery = new Battery();
    private final LowBatteryAlarm alarm = new LowBatteryAlarm(settings, battery, buzzer);
    private final Compass compass = new Compass();
    private final HostBaud hostBaud = new HostBaud();
    private final List<AuxPort> auxPorts = List.of(
            new AuxPort(0xB0, Setting.AUX1_BAUD, settings),
            new AuxPort(0xB8, Setting.AUX2_BAUD, settings),
            new AuxPort(0xC8, Setting.AUX3_BAUD, settings));
    private final Charger charger;
    private final Gripper gripper;
    private final Gyro gyro;

    /** Whether a device may be active, so that its time passes in each step. */
    private boolean used = true;

    /** The time that has not yet passed on the devices, with effort and turn rate meanwhile. */
    private long leftNanos;

    private double leftEffort;
    private double leftDegPerSec;

    public Devices(Equipment equipment, Noise noise) {
        charger = new Charger(equipment.hasCharger(), battery);
        gripper = new Gripper(equipment.hasGripper());
        gyro = new Gyro(noise.fork("gyro"));
    }

    public Settings settings() {
        return settings;
    }

    public UserPort userPort() {
        return userPort;
    }

    public Infrared infrared() {
        return infrared;
    }

    public StopButton stopButton() {
        return stopButton;
    }

    public Joystick joystick() {
        return joystick;
    }

    public Thermometer thermometer() {
        return thermometer;
    }

    public Buzzer buzzer() {
        use();
        return buzzer;
    }

    public Battery battery() {
        use();
        return battery;
    }

    public Charger charger() {
        use();
        return charger;
    }

    public Compass compass() {
        return compass;
    }

    public HostBaud hostBaud() {
        use();
        return hostBaud;
    }

    public Gripper gripper() {
        use();
        return gripper;
    }

    public Gyro gyro() {
        use();
        return gyro;
    }

    /** AUX1 to AUX3. */
    public List<AuxPort> auxPorts() {
        use();
        return auxPorts;
    }

    /** Begins or ends a session: restores the stored values and ends the tune (ARCOS sheet 5.1). */
    public void restore() {
        use();
        settings.restore();
        buzzer.silence();
        buzzer.mute(false);
        compass.enable(true);
        hostBaud.restore();
    }

    /** Restarts the controller: also restores what the end of a session leaves. */
    public void reset() {
        restore();
        userPort.output(0xFF, 0xFF);
        userPort.show(0);
        battery.pretend(0);
        charger.deploy(true);
        gripper.halt();
        auxPorts.forEach(port -> port.request(0));
    }

    /** Whether only time passes on them, so that a long step has the same effect as many short ones. */
    public boolean isAtRest() {
        return !gripper.isMoving() && !buzzer.isPlaying() && !hostBaud.isOnTrial() && !isTransmitting();
    }

    private boolean isTransmitting() {
        for (AuxPort port : auxPorts) {
            if (port.isTransmitting()) {
                return true;
            }
        }
        return false;
    }

    /**
     * Lets time pass. As long as the devices are at rest and nothing changes, it passes a tenth of a second at a time,
     * or when one of them is read or changed.
     *
     * @param effort how much of its top speed the robot drives, 0 to 1
     * @param trueDegPerSec its true turn rate
     */
    public void step(long nanos, double effort, double trueDegPerSec) {
        if (effort != leftEffort || trueDegPerSec != leftDegPerSec) {
            catchUp();
            leftEffort = effort;
            leftDegPerSec = trueDegPerSec;
        }
        leftNanos += nanos;
        if (used || leftNanos >= LONGEST_NANOS) {
            catchUp();
        }
    }

    /** Called before a device is read or changed, which may end its rest. */
    private void use() {
        catchUp();
        used = true;
    }

    private void catchUp() {
        if (leftNanos > 0) {
            long nanos = leftNanos;
            leftNanos = 0;
            pass(nanos, nanos / 1e9);
            used = !isAtRest();
        }
    }

    private void pass(long nanos, double seconds) {
        battery.step(seconds, IDLE_AMPERES + DRIVING_AMPERES * leftEffort - charger.amperes());
        gripper.step(seconds);
        gyro.step(nanos, leftDegPerSec);
        buzzer.step(nanos);
        alarm.step(nanos);
        hostBaud.step(nanos);
        for (AuxPort port : auxPorts) {
            port.step(seconds);
        }
    }
}
