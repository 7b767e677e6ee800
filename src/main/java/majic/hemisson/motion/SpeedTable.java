package majic.hemisson.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import majic.hemisson.line.MotorValues;

/**
 * How fast the wheels run for each motor value, and how far apart they are, for one robot. Nothing on the robot
 * measures it, so it can only be calibrated by the user. Immutable.
 *
 * @param speedsMmPerSec the mean speed of the two wheels for the motor values 1 to 9, mm/s, rising
 * @param wheelDistanceMm from wheel to wheel, mm
 * @param trimPercent by how much the right wheel runs faster than the left one at the same value, %
 */
public record SpeedTable(List<Double> speedsMmPerSec, double wheelDistanceMm, double trimPercent) {
    /** The sheet's credible value; makers of other clients used 110 and 112. */
    static final double USUAL_WHEEL_DISTANCE_MM = 90;

    /** The slowest value that reliably overcomes friction. */
    public static final int SLOWEST = 2;

    /** The curve in the manual (Hemisson sheet 5). */
    static final List<Double> MANUAL = List.of(3.0, 18.0, 42.0, 64.0, 86.0, 109.0, 134.0, 156.0, 184.0);

    public static final SpeedTable USUAL = new SpeedTable(MANUAL, USUAL_WHEEL_DISTANCE_MM, 0);

    public SpeedTable {
        speedsMmPerSec = List.copyOf(speedsMmPerSec);
        if (!isRising(speedsMmPerSec) || !(wheelDistanceMm > 0) || !(Math.abs(trimPercent) < 100)) {
            throw new IllegalArgumentException(
                    "not a calibration: " + speedsMmPerSec + ", " + wheelDistanceMm + ", " + trimPercent);
        }
    }

    /** Whether these can be the speeds for the motor values 1 to 9. */
    public static boolean isRising(List<Double> speeds) {
        double before = 0;
        for (double speed : speeds) {
            if (!(speed > before)) {
                return false;
            }
            before = speed;
        }
        return speeds.size() == MotorValues.MAX;
    }

    /** All speeds multiplied by a factor. */
    SpeedTable scaled(double factor) {
        List<Double> scaled = new ArrayList<>();
        speedsMmPerSec.forEach(speed -> scaled.add(speed * factor));
        return new SpeedTable(scaled, wheelDistanceMm, trimPercent);
    }

    public SpeedTable withSpeeds(List<Double> newMmPerSec) {
        return new SpeedTable(newMmPerSec, wheelDistanceMm, trimPercent);
    }

    public SpeedTable withWheelDistance(double mm) {
        return new SpeedTable(speedsMmPerSec, mm, trimPercent);
    }

    public SpeedTable withTrim(double percent) {
        return new SpeedTable(speedsMmPerSec, wheelDistanceMm, percent);
    }

    /** The mean speed of the wheels, mm/s, for a motor value of -9 to 9. */
    public double mmPerSec(int value) {
        return value == 0 ? 0 : Math.signum(value) * speedsMmPerSec.get(Math.abs(value) - 1);
    }

    /** What the left wheel's speed is of the mean. */
    double leftFactor() {
        return 1 - trimPercent / 200;
    }

    /** What the right wheel's speed is of the mean. */
    double rightFactor() {
        return 1 + trimPercent / 200;
    }

    /** The highest speed that both wheels reach, mm/s. */
    public double fastestMmPerSec() {
        return mmPerSec(MotorValues.MAX) * Math.min(leftFactor(), rightFactor());
    }

    /** The rate at which it spins with both wheels at a value, deg/s. */
    public double spinDegPerSec(int value) {
        return Math.toDegrees(2 * mmPerSec(value) / wheelDistanceMm);
    }

    /** The value that comes nearest to a mean wheel speed; 0 or one that turns the wheel. */
    int nearest(double wantedMmPerSec) {
        int best = 0;
        for (int value = SLOWEST; value <= MotorValues.MAX; value++) {
            if (Math.abs(mmPerSec(value) - Math.abs(wantedMmPerSec))
                    < Math.abs(mmPerSec(best) - Math.abs(wantedMmPerSec))) {
                best = value;
            }
        }
        return wantedMmPerSec < 0 ? -best : best;
    }

    /** The nearest wheel values for a curve; one too fast is slowed down without bending it otherwise. */
    public MotorValues curve(double speedMmPerSec, double turnDegPerSec) {
        double half = Math.toRadians(turnDegPerSec) * wheelDistanceMm / 2;
        double left = speedMmPerSec - half;
        double right = speedMmPerSec + half;
        double slower = Math.min(1, fastestMmPerSec() / Math.max(1, Math.max(Math.abs(left), Math.abs(right))));
        return new MotorValues(nearest(left * slower / leftFactor()), nearest(right * slower / rightFactor()));
    }

    /** Returns the motor values with the speeds that result, as a text for users. */
    public String words(MotorValues wheels) {
        return String.format(
                Locale.ROOT,
                "motor values %d and %d: about %d mm/s, %d deg/s",
                wheels.left(),
                wheels.right(),
                Math.round(speedMmPerSec(wheels)),
                Math.round(turnDegPerSec(wheels)));
    }

    /** The path speed for wheel values, mm/s, ahead positive. */
    public double speedMmPerSec(MotorValues wheels) {
        return (leftMmPerSec(wheels) + rightMmPerSec(wheels)) / 2;
    }

    /** The turn rate for wheel values, deg/s, left positive. */
    public double turnDegPerSec(MotorValues wheels) {
        return Math.toDegrees((rightMmPerSec(wheels) - leftMmPerSec(wheels)) / wheelDistanceMm);
    }

    private double leftMmPerSec(MotorValues wheels) {
        return mmPerSec(wheels.left()) * leftFactor();
    }

    private double rightMmPerSec(MotorValues wheels) {
        return mmPerSec(wheels.right()) * rightFactor();
    }
}
