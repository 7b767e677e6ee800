package majic.pioneer.state;

import majic.pioneer.arcos.Sip;
import majic.pioneer.arcos.SipTail;

/**
 * The units of the counts in a SIP (ARCOS sheet 9.1). The heading has 4096 units a turn in every model. Immutable.
 *
 * @param mmPerCount of x and y
 * @param mmPerSecPerCount of the wheels' velocities
 * @param mmPerRangeCount of the sonar ranges
 * @param radPerMm turn rate for half the difference of the wheels' velocities
 */
public record Scaling(double mmPerCount, double mmPerSecPerCount, double mmPerRangeCount, double radPerMm) {
    /** Units of the heading in a full turn. */
    static final int UNITS_PER_TURN = 4096;

    public static final double DEG_PER_UNIT = 360.0 / UNITS_PER_TURN;

    public double leftMmPerSec(Sip sip) {
        return sip.lVel() * mmPerSecPerCount;
    }

    public double rightMmPerSec(Sip sip) {
        return sip.rVel() * mmPerSecPerCount;
    }

    double speedMmPerSec(Sip sip) {
        return (sip.lVel() + sip.rVel()) / 2.0 * mmPerSecPerCount;
    }

    /** From the SIP's own field where it has one, else from the wheels. */
    double turnRateDegPerSec(Sip sip) {
        if (sip.tail().turnRateTenths() != SipTail.ABSENT) {
            return sip.tail().turnRateTenths() / 10.0;
        }
        return Math.toDegrees((sip.rVel() - sip.lVel()) / 2.0 * mmPerSecPerCount * radPerMm);
    }
}
