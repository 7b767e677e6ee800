package majic.hemisson.motion;

import majic.bot.Unit;
import majic.hemisson.line.MotorValues;

/**
 * A motion of the open-loop robot: motor values and a duration (Hemisson sheet 13). Motor values are whole numbers, so
 * where one wheel runs faster than the other it is slowed for a share of the time. Immutable.
 *
 * @param wheels the motor values
 * @param eased the motor values in between, with the faster wheel one value lower
 * @param easedShare the share of the time for those, 0 to 1
 * @param seconds the whole duration
 * @param perSecond the way in a second, mm or degrees, signed
 * @param unit of the way
 */
public record TimedMotion(
        MotorValues wheels, MotorValues eased, double easedShare, double seconds, double perSecond, Unit unit) {
    /** A shorter motion is made slower, so that the timing of the line matters less. */
    private static final double SHORTEST_SECONDS = 0.4;

    /** About how long both wheels keep the same value before one is slowed, seconds. */
    private static final double ROUND_SECONDS = 1;

    public static TimedMotion straight(double mm, double cruiseMmPerSec, SpeedTable table) {
        int value = slowed(Math.abs(mm), cruiseMmPerSec, table);
        int sign = mm < 0 ? -1 : 1;
        boolean rightIsFaster = table.trimPercent() > 0;
        double slower = Math.min(table.leftFactor(), table.rightFactor());
        double faster = Math.max(table.leftFactor(), table.rightFactor());
        double step = table.mmPerSec(value) - table.mmPerSec(value - 1);
        double share = (1 - slower / faster) * table.mmPerSec(value) / step;
        double speed = sign * slower * table.mmPerSec(value);
        return new TimedMotion(
                new MotorValues(sign * value, sign * value),
                new MotorValues(sign * (rightIsFaster ? value : value - 1), sign * (rightIsFaster ? value - 1 : value)),
                Math.min(1, share),
                mm / speed,
                speed,
                Unit.MM);
    }

    public static TimedMotion spin(double degrees, double cruiseDegPerSec, SpeedTable table) {
        double wayPerDegree = Math.toRadians(1) * table.wheelDistanceMm() / 2;
        int value = slowed(Math.abs(degrees) * wayPerDegree, cruiseDegPerSec * wayPerDegree, table);
        int signed = degrees < 0 ? -value : value;
        double rate = table.spinDegPerSec(signed);
        MotorValues wheels = new MotorValues(-signed, signed);
        return new TimedMotion(wheels, wheels, 0, degrees / rate, rate, Unit.DEG);
    }

    /** How often a wheel is slowed. */
    int rounds() {
        return easedShare == 0 ? 0 : (int) Math.max(1, Math.round(seconds / ROUND_SECONDS));
    }

    /** The whole way, mm or degrees, signed. */
    double way() {
        return perSecond * seconds;
    }

    private static int slowed(double wayMm, double cruiseMmPerSec, SpeedTable table) {
        int value = Math.max(SpeedTable.SLOWEST, table.nearest(cruiseMmPerSec));
        while (value > SpeedTable.SLOWEST && wayMm / table.mmPerSec(value) < SHORTEST_SECONDS) {
            value--;
        }
        return value;
    }
}
