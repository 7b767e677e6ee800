package majic.hemisson.line;

/**
 * The values of the two motors, each -9 to 9, ahead positive. Immutable; larger values are clamped, because the robot
 * misreads them without an error (Hemisson sheet 4.3).
 *
 * @param left the left motor
 * @param right the right motor
 */
public record MotorValues(int left, int right) {
    public static final int MAX = 9;
    public static final MotorValues STILL = new MotorValues(0, 0);

    public MotorValues {
        left = Math.max(-MAX, Math.min(MAX, left));
        right = Math.max(-MAX, Math.min(MAX, right));
    }

    /** The values that the robot reports. */
    public static MotorValues of(Reply speeds) {
        return new MotorValues(speeds.numbers().get(0), speeds.numbers().get(1));
    }

    public boolean isStill() {
        return left == 0 && right == 0;
    }
}
