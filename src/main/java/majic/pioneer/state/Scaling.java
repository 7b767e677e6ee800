package majic.pioneer.state;

import majic.pioneer.arcos.Sip;
import majic.pioneer.arcos.SipField;

/**
 * The units of the counts in a SIP (ARCOS sheet 9.1). Immutable.
 *
 * @param mmPerCount of x and y; 0 if it is not known
 * @param degPerCount of the heading; 0 if it is not known
 * @param mmPerSecPerCount of the wheels' velocities
 * @param mmPerRangeCount of the sonar ranges
 * @param radPerMm turn rate for half the difference of the wheels' velocities
 */
public record Scaling(
        double mmPerCount, double degPerCount, double mmPerSecPerCount, double mmPerRangeCount, double radPerMm) {
    /** Of the heading, except for the oldest models. */
    public static final double DEG_PER_UNIT = 360.0 / 4096;

    /** Of current robots, which count in mm. */
    public static final Scaling CURRENT = new Scaling(1, DEG_PER_UNIT, 1, 1, 0.0056);

    /** Of a model of which nothing is known: the pose stays as it is, and the speeds are only roughly right. */
    static final Scaling UNKNOWN = new Scaling(0, 0, 1, 1, CURRENT.radPerMm);

    /** Factors for the heading in parameter files are rounded to this share of their value. */
    private static final double ROUNDING = 0.005;

    /**
     * The angle of one count of the heading, which has 4096 or 1024 counts a turn. A factor that is one of these but
     * for its rounding becomes exact.
     *
     * @param radPerCount as in a parameter file, positive
     * @return degrees
     */
    static double degPerCount(double radPerCount) {
        double given = Math.toDegrees(radPerCount);
        double exact = 360.0 / countsPerTurn(given);
        return Math.abs(given - exact) <= ROUNDING * exact ? exact : given;
    }

    boolean isKnown() {
        return mmPerCount > 0;
    }

    /** Where the counter of the heading rolls over: a power of two. */
    int countsPerTurn() {
        return degPerCount == 0 ? countsPerTurn(DEG_PER_UNIT) : countsPerTurn(degPerCount);
    }

    private static int countsPerTurn(double degPerCount) {
        return 1 << (int) Math.round(Math.log(360 / degPerCount) / Math.log(2));
    }

    public double leftMmPerSec(Sip sip) {
        return sip.get(SipField.L_VEL) * mmPerSecPerCount;
    }

    public double rightMmPerSec(Sip sip) {
        return sip.get(SipField.R_VEL) * mmPerSecPerCount;
    }

    double speedMmPerSec(Sip sip) {
        return (sip.get(SipField.L_VEL) + sip.get(SipField.R_VEL)) / 2.0 * mmPerSecPerCount;
    }

    /** From the SIP's own field where it has one, else from the wheels. */
    double turnRateDegPerSec(Sip sip) {
        int tenths = sip.get(SipField.TURN_RATE_TENTHS);
        if (tenths != Sip.ABSENT) {
            return tenths / 10.0;
        }
        return Math.toDegrees((sip.get(SipField.R_VEL) - sip.get(SipField.L_VEL)) / 2.0 * mmPerSecPerCount * radPerMm);
    }
}
