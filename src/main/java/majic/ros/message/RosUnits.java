package majic.ros.message;

/**
 * Converts between the units of ROS (REP-103) and those of MAJIC. The signs are the same: x ahead, y left, left turns
 * positive.
 */
final class RosUnits {
    private static final double MM_PER_M = 1000;

    private RosUnits() {}

    static double mm(double metres) {
        return metres * MM_PER_M;
    }

    static double metres(double mm) {
        return mm / MM_PER_M;
    }
}
