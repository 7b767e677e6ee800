package majic.hemisson.line;

/**
 * What the two motors are told, each -9 to 9, ahead positive. Immutable; values beyond are clamped, since the robot
 * silently misreads them (Hemisson sheet 4.3).
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

    /** What the robot says its motors are set to. */
    public static MotorValues of(Reply speeds) {
        return new MotorValues(speeds.numbers().get(0), speeds.numbers().get(1));
    }

    public boolean isStill() {
        return left == 0 && right == 0;
    }
}
