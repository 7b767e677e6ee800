package majic.pioneer.state;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import majic.bot.Pose;
import majic.pioneer.arcos.Gyro;
import majic.pioneer.arcos.Joystick;
import majic.pioneer.arcos.Sip;
import majic.pioneer.arcos.SipField;

/**
 * The state that a Pioneer last reported: its latest SIP in usual units, and the latest of each report that comes
 * beside the SIPs. Immutable.
 *
 * @param sip as sent
 * @param reports the latest of each other report
 * @param pose by odometry, from where it was connected
 * @param turnedDeg all turning so far, counterclockwise positive, not reduced to one turn
 * @param speedMmPerSec from the wheels, ahead positive
 * @param turnRateDegPerSec counterclockwise positive
 * @param sonar the last reading of every disc, and the recent echoes
 * @param sipsPerSec SIPs per second, 0 before the second SIP
 * @param longestSilenceS between two SIPs of this session, seconds
 * @param atNanos when this came, on the driver's clock
 */
public record PioneerState(
        Sip sip,
        LatestReports reports,
        Pose pose,
        double turnedDeg,
        double speedMmPerSec,
        double turnRateDegPerSec,
        SonarScan sonar,
        double sipsPerSec,
        double longestSilenceS,
        long atNanos) {
    private static final double STATIONARY_MM_PER_SEC = 3;
    private static final double STATIONARY_DEG_PER_SEC = 1;
    private static final int MOTOR_STALL = 1;
    private static final int MOTORS = 1;
    private static final int SONAR_ARRAYS = 0b11110;
    private static final int STOP_BUTTON = 1 << 5;
    private static final int STOP_ENGAGED = 1 << 6;
    private static final int FAR_LEDGE = 1 << 7;
    private static final int NEAR_LEDGE = 1 << 8;
    private static final int DEG_PER_COMPASS_STEP = 2;

    /** At or below this the byte means that there is no thermometer (ARCOS sheet 17). */
    private static final int NO_TEMPERATURE = -127;

    /** This state with newer reports. */
    PioneerState with(LatestReports newReports) {
        return new PioneerState(
                sip,
                newReports,
                pose,
                turnedDeg,
                speedMmPerSec,
                turnRateDegPerSec,
                sonar,
                sipsPerSec,
                longestSilenceS,
                atNanos);
    }

    /** From the hull to the nearest obstacle on each known side, mm; infinite if none is in range. Unmodifiable. */
    public Map<Side, Double> gaps() {
        return sonar.gaps();
    }

    public boolean isMoving() {
        return Math.abs(speedMmPerSec) > STATIONARY_MM_PER_SEC || Math.abs(turnRateDegPerSec) > STATIONARY_DEG_PER_SEC;
    }

    /** FLAGS bit 0 (ARCOS sheet 8.1). */
    public boolean motorsOn() {
        return hasFlag(MOTORS);
    }

    /** FLAGS bits 1 to 4, one for each array. */
    public boolean sonarOn() {
        return hasFlag(SONAR_ARRAYS);
    }

    /** FLAGS bits 1 to 4 again: one array, by its number. */
    public boolean sonarOn(int array) {
        return hasFlag(1 << array);
    }

    /** FLAGS bit 5. */
    public boolean stopButton() {
        return hasFlag(STOP_BUTTON);
    }

    /** FLAGS bit 6: the STOP button, or a condition like it, keeps the motors off. */
    public boolean stopEngaged() {
        return hasFlag(STOP_ENGAGED);
    }

    /** FLAGS bits 7 and 8: an infra-red sensor detects a step down, far ahead or near. */
    public boolean ledge() {
        return hasFlag(FAR_LEDGE | NEAR_LEDGE);
    }

    private boolean hasFlag(int bits) {
        return (sip.get(SipField.FLAGS) & bits) != 0;
    }

    public boolean stallLeft() {
        return (sip.get(SipField.STALL_REAR) & MOTOR_STALL) != 0;
    }

    public boolean stallRight() {
        return (sip.get(SipField.STALL_FRONT) & MOTOR_STALL) != 0;
    }

    public boolean stalled() {
        return stallLeft() || stallRight();
    }

    /** The front bumper's segments as bits, segment 1 lowest (ARCOS sheet 8, 17). */
    int frontBumpers() {
        return sip.get(SipField.STALL_FRONT) >> 1;
    }

    /** The rear bumper's segments as bits, segment 1 lowest. */
    int rearBumpers() {
        return sip.get(SipField.STALL_REAR) >> 1;
    }

    /** Volts, from the field that also holds more than 25.5 V where the robot sends it. */
    public double volts() {
        return sip.get(sip.has(SipField.BATTERY_TENTHS) ? SipField.BATTERY_TENTHS : SipField.BATTERY) / 10.0;
    }

    /** Battery and charger. */
    public Power power() {
        return Power.of(this);
    }

    /** Digital and analog inputs and outputs. */
    public IoPorts ports() {
        return IoPorts.of(this);
    }

    /** Gripper and lift; valid only if CONFIG reports a gripper. */
    public Optional<Gripper> gripper() {
        return sip.has(SipField.GRIP_STATE) ? Optional.of(Gripper.of(sip.get(SipField.GRIP_STATE))) : Optional.empty();
    }

    /** The heading of the compass, 0 to 358 in steps of 2; empty without a compass. */
    public OptionalInt compassDeg() {
        int steps = sip.get(SipField.COMPASS);
        return steps == 0 ? OptionalInt.empty() : OptionalInt.of(steps * DEG_PER_COMPASS_STEP);
    }

    /** The turn rate by the gyro, deg/s, counterclockwise positive; empty before the first report. */
    public OptionalDouble gyroDegPerSec() {
        return reports.latest(Gyro.class).map(Gyro::degPerSec).orElse(OptionalDouble.empty());
    }

    /** Of the controller, °C; empty without a thermometer. */
    public OptionalInt temperatureC() {
        int sent = sip.get(SipField.TEMPERATURE);
        return sent <= NO_TEMPERATURE ? OptionalInt.empty() : OptionalInt.of(sent);
    }

    /** FAULT_FLAGS, 0 when all is well; empty on older firmware (ARCOS sheet 8). */
    public OptionalInt faults() {
        return sip.has(SipField.FAULT_FLAGS) ? OptionalInt.of(sip.get(SipField.FAULT_FLAGS)) : OptionalInt.empty();
    }

    /** The robot's plugged-in joystick; empty before the first report. */
    public Optional<Joystick> joystick() {
        return reports.latest(Joystick.class);
    }

    /** The encoder counts; empty before the first report. */
    public Optional<EncoderTicks> encoders() {
        return reports.ticks();
    }
}
