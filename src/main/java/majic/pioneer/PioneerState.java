package majic.pioneer;

import java.util.Map;
import majic.bot.Pose;
import majic.pioneer.arcos.Sip;
import majic.pioneer.arcos.SipTail;

/**
 * All that a Pioneer last said of itself. Immutable.
 *
 * @param sip as sent
 * @param pose by odometry, from where it was connected
 * @param turnedDeg all turning so far, counterclockwise positive, not brought to one turn
 * @param speedMmPerSec from the wheels, ahead positive
 * @param turnRateDegPerSec counterclockwise positive
 * @param sonar the last reading of every disc
 * @param gaps from the hull to the nearest thing on each side that is known, mm; infinite when nothing is in range
 * @param sipsPerSec how often it speaks, 0 before the second SIP
 * @param atNanos when this came, on the driver's clock
 */
record PioneerState(
        Sip sip,
        Pose pose,
        double turnedDeg,
        double speedMmPerSec,
        double turnRateDegPerSec,
        SonarScan sonar,
        Map<Side, Double> gaps,
        double sipsPerSec,
        long atNanos) {
    private static final double STANDING_MM_PER_SEC = 3;
    private static final double STANDING_DEG_PER_SEC = 1;
    private static final int MOTOR_STALL = 1;
    private static final int MOTORS = 1;
    private static final int SONAR_ARRAYS = 0b11110;
    private static final int STOP_BUTTON = 1 << 5;

    /** Keeps a copy of the gaps. */
    PioneerState {
        gaps = Map.copyOf(gaps);
    }

    boolean isMoving() {
        return Math.abs(speedMmPerSec) > STANDING_MM_PER_SEC || Math.abs(turnRateDegPerSec) > STANDING_DEG_PER_SEC;
    }

    /** FLAGS bit 0 (ARCOS sheet 8.1). */
    boolean motorsOn() {
        return (sip.flags() & MOTORS) != 0;
    }

    /** FLAGS bits 1 to 4, one for each array. */
    boolean sonarOn() {
        return (sip.flags() & SONAR_ARRAYS) != 0;
    }

    /** FLAGS bit 5. */
    boolean stopButton() {
        return (sip.flags() & STOP_BUTTON) != 0;
    }

    boolean stallLeft() {
        return (sip.stallRear() & MOTOR_STALL) != 0;
    }

    boolean stallRight() {
        return (sip.stallFront() & MOTOR_STALL) != 0;
    }

    boolean stalled() {
        return stallLeft() || stallRight();
    }

    /** The front bumper's segments as bits, segment 1 lowest (ARCOS sheet 8, 17). */
    int frontBumpers() {
        return sip.stallFront() >> 1;
    }

    /** The rear bumper's segments as bits, segment 1 lowest. */
    int rearBumpers() {
        return sip.stallRear() >> 1;
    }

    /** Volts, from the field that also holds more than 25.5 V where the robot sends it. */
    double volts() {
        int exact = sip.tail().batteryTenths();
        return (exact == SipTail.ABSENT ? sip.battery() : exact) / 10.0;
    }
}
