package majic.hemisson;

import majic.bot.Unit;
import majic.bot.Value;

/**
 * One motion of the open-loop robot: these wheel values for so long (Hemisson sheet 13). Immutable.
 *
 * @param wheels what the motors are told
 * @param seconds for how long
 * @param perSecond what that makes in a second, mm or degrees, signed
 * @param unit of which of them
 */
record Leg(Wheels wheels, double seconds, double perSecond, Unit unit) {
    /** A leg shorter than this goes slower, so that the timing of the line matters less. */
    private static final double SHORTEST_SECONDS = 0.4;

    static Leg straight(double mm, double cruiseMmPerSec, SpeedTable table) {
        int value = slowed(Math.abs(mm), cruiseMmPerSec, table);
        int signed = mm < 0 ? -value : value;
        double speed = table.mmPerSec(signed);
        return new Leg(new Wheels(signed, signed), mm / speed, speed, Unit.MM);
    }

    static Leg spin(double degrees, double cruiseDegPerSec, SpeedTable table) {
        double wayPerDegree = Math.toRadians(1) * table.wheelDistanceMm() / 2;
        int value = slowed(Math.abs(degrees) * wayPerDegree, cruiseDegPerSec * wayPerDegree, table);
        int signed = degrees < 0 ? -value : value;
        double rate = table.spinDegPerSec(signed);
        return new Leg(new Wheels(-signed, signed), degrees / rate, rate, Unit.DEG);
    }

    /** What was covered in a time, always an estimate. */
    Value covered(double afterSeconds) {
        return Value.about(perSecond * Math.max(0, afterSeconds), unit);
    }

    private static int slowed(double wayMm, double cruiseMmPerSec, SpeedTable table) {
        int value = Math.max(SpeedTable.SLOWEST, table.nearest(cruiseMmPerSec));
        while (value > SpeedTable.SLOWEST && wayMm / table.mmPerSec(value) < SHORTEST_SECONDS) {
            value--;
        }
        return value;
    }
}
