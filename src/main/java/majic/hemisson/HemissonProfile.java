package majic.hemisson;

import majic.bot.BotProfile;
import majic.bot.Range;
import majic.hemisson.line.MotorValues;
import majic.hemisson.motion.SpeedTable;
import majic.hemisson.readings.Clearance;

/** Size and speeds of a Hemisson. */
final class HemissonProfile {
    private static final double CRUISE_MM_PER_S = 42;
    private static final double CRUISE_TURN_DEG_PER_S = 53;
    private static final double NEAR_MM = 40;

    private HemissonProfile() {}

    /** The profile for a calibration. */
    static BotProfile of(SpeedTable table) {
        double fastest = table.fastestMmPerSec();
        double fastestSpin = table.spinDegPerSec(MotorValues.MAX);
        return new BotProfile(
                Clearance.HULL_MM,
                new Range(-fastest, fastest),
                new Range(-fastestSpin, fastestSpin),
                table.mmPerSec(SpeedTable.SLOWEST),
                table.spinDegPerSec(SpeedTable.SLOWEST),
                CRUISE_MM_PER_S,
                CRUISE_TURN_DEG_PER_S,
                NEAR_MM,
                true);
    }
}
