package majicsim.ros.robot;

/**
 * A velocity of the base in its own frame.
 *
 * @param metresPerSec ahead, negative backward
 * @param radPerSec counter-clockwise
 */
record Velocity(double metresPerSec, double radPerSec) {
    static final Velocity ZERO = new Velocity(0, 0);

    boolean isZero() {
        return metresPerSec == 0 && radPerSec == 0;
    }
}
