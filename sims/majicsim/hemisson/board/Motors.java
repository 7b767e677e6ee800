package majicsim.hemisson.board;

import majicsim.world.Body;
import majicsim.world.Noise;

/**
 * Two motors without encoders: a value sets a pulse width at once and stays (sheet 5). There is no watchdog, and a
 * blocked robot's values are still what was asked.
 */
public final class Motors {
    /** Wheel speed by value; the curve of the manual. */
    private static final double[] MM_PER_SEC = {0, 3, 18, 42, 64, 86, 109, 134, 156, 184};

    /** Beyond the curve, up to full duty at value 16. */
    private static final double MM_PER_SEC_A_VALUE = 23;

    private static final int FULL_DUTY = 16;
    private static final double WHEEL_DISTANCE_MM = 90;
    private static final double MISMATCH = 0.05;

    private final Body body;
    private final double leftFactor;
    private final double rightFactor;
    private int left;
    private int right;
    private boolean lifted;

    public Motors(Body body, Noise noise, double mismatchPercent) {
        this.body = body;
        double half = mismatchPercent / 200;
        leftFactor = noise.uniform(1 - MISMATCH, 1 + MISMATCH) * (1 - half);
        rightFactor = noise.uniform(1 - MISMATCH, 1 + MISMATCH) * (1 + half);
    }

    /** Signed bytes; the driver's limit of 9 is not the robot's. */
    public void set(int leftValue, int rightValue) {
        left = (byte) leftValue;
        right = (byte) rightValue;
        roll();
    }

    /** Lifts the robot, so that its wheels turn and it does not move. */
    public void lift(boolean up) {
        lifted = up;
        roll();
    }

    private void roll() {
        if (lifted) {
            body.velocity(0, 0);
            return;
        }
        double leftMmPerSec = wheelMmPerSec(left) * leftFactor;
        double rightMmPerSec = wheelMmPerSec(right) * rightFactor;
        body.velocity(
                (leftMmPerSec + rightMmPerSec) / 2, Math.toDegrees((rightMmPerSec - leftMmPerSec) / WHEEL_DISTANCE_MM));
    }

    public int left() {
        return left;
    }

    public int right() {
        return right;
    }

    static double wheelMmPerSec(int value) {
        int size = Math.min(Math.abs(value), FULL_DUTY);
        int last = MM_PER_SEC.length - 1;
        double speed = size <= last ? MM_PER_SEC[size] : MM_PER_SEC[last] + (size - last) * MM_PER_SEC_A_VALUE;
        return Math.copySign(speed, value);
    }
}
