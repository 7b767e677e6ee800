package majicsim.ros.robot;

import majicsim.world.Body;
import majicsim.world.Noise;

/**
 * The two wheels of a TurtleBot3 Burger. They reach a commanded speed with limited acceleration and do not turn while
 * the body is blocked. A command is clamped, holds until the next one, and ends after the time-out if there is one.
 */
final class BurgerDrive {
    /** The fastest commands that the base takes (sheet 9). */
    static final double MOST_METRES_PER_SEC = 0.22;

    static final double MOST_RAD_PER_SEC = 2.84;

    /** Half the distance between the wheels. */
    static final double HALF_TRACK_M = 0.08;

    private static final double ACCELERATION = 2.5;
    private static final double DIAMETER_ERROR = 0.003;
    private static final double MM = 1000;

    private final Body body;
    private final double timeoutS;
    private final double leftScale;
    private final double rightScale;
    private Velocity wanted = Velocity.ZERO;
    private double sinceCommandS;
    private boolean isPowered = true;
    private double leftMetresPerSec;
    private double rightMetresPerSec;
    private double measuredLeft;
    private double measuredRight;

    /** Drives a body; {@code timeoutS} 0 means that a command holds for ever. */
    BurgerDrive(Body body, double timeoutS, Noise noise) {
        this.body = body;
        this.timeoutS = timeoutS;
        this.leftScale = noise.scale(DIAMETER_ERROR);
        this.rightScale = noise.scale(DIAMETER_ERROR);
    }

    /** Switches the motors on or off; off ends the present command. */
    void power(boolean on) {
        isPowered = on;
        wanted = on ? wanted : Velocity.ZERO;
    }

    /** Takes a command. A speed that is not a number counts as 0: no motor can follow it. */
    void command(Velocity velocity) {
        Velocity followed = new Velocity(
                clamped(velocity.metresPerSec(), MOST_METRES_PER_SEC), clamped(velocity.radPerSec(), MOST_RAD_PER_SEC));
        wanted = isPowered ? followed : Velocity.ZERO;
        sinceCommandS = 0;
    }

    private static double clamped(double value, double most) {
        return Double.isNaN(value) ? 0 : Math.max(-most, Math.min(most, value));
    }

    /** Measures the motion since the last step, then sets the speeds of the next one. */
    void step(double seconds) {
        measure();
        sinceCommandS += seconds;
        if (timeoutS > 0 && sinceCommandS > timeoutS) {
            wanted = Velocity.ZERO;
        }
        double turning = wanted.radPerSec() * HALF_TRACK_M;
        leftMetresPerSec = towards(leftMetresPerSec, wanted.metresPerSec() - turning, seconds);
        rightMetresPerSec = towards(rightMetresPerSec, wanted.metresPerSec() + turning, seconds);
        double left = leftMetresPerSec * leftScale;
        double right = rightMetresPerSec * rightScale;
        body.velocity((left + right) / 2 * MM, Math.toDegrees((right - left) / (2 * HALF_TRACK_M)));
    }

    /** What the encoders count: the true motion, by wheels of the nominal diameter. */
    private void measure() {
        double ahead = body.speedMmPerSec() / MM;
        double turning = Math.toRadians(body.turnDegPerSec()) * HALF_TRACK_M;
        measuredLeft = (ahead - turning) / leftScale;
        measuredRight = (ahead + turning) / rightScale;
    }

    private static double towards(double from, double to, double seconds) {
        double most = ACCELERATION * seconds;
        return from + Math.max(-most, Math.min(most, to - from));
    }

    /** The speed of the left wheel in the last step, m/s. */
    double measuredLeft() {
        return measuredLeft;
    }

    /** The speed of the right wheel in the last step, m/s. */
    double measuredRight() {
        return measuredRight;
    }

    /** Whether neither motion nor a command is left. */
    boolean isResting() {
        return wanted.isZero()
                && leftMetresPerSec == 0
                && rightMetresPerSec == 0
                && measuredLeft == 0
                && measuredRight == 0;
    }
}
