package majicsim.pioneer.model;

/**
 * The factors between a model's raw numbers in packets and values: raw times factor is the value (ARCOS sheet 9.1).
 *
 * @param mmPerPositionUnit for x and y in the SIP only
 * @param headingUnitsPerTurn for the heading, a power of two
 * @param mmPerSecPerSpeedUnit for the wheel speeds
 * @param mmPerRangeUnit for sonar ranges
 * @param radPerMm turn in radians for each mm that the right wheel does more than the middle, the left one less
 * @param vel2UnitMmPerSec the unit of VEL2's two bytes
 */
public record Scaling(
        double mmPerPositionUnit,
        double headingUnitsPerTurn,
        double mmPerSecPerSpeedUnit,
        double mmPerRangeUnit,
        double radPerMm,
        double vel2UnitMmPerSec) {
    public int position(double mm) {
        return (int) Math.round(mm / mmPerPositionUnit);
    }

    /** The heading in these units, from half a turn to the right up to half a turn to the left. */
    public int heading(double degrees) {
        int turn = (int) headingUnitsPerTurn;
        int units = Math.floorMod((int) Math.round(degrees * turn / 360), turn);
        return units >= turn / 2 ? units - turn : units;
    }

    public int speed(double mmPerSec) {
        return (int) Math.round(mmPerSec / mmPerSecPerSpeedUnit);
    }

    public int range(double mm) {
        return (int) Math.round(mm / mmPerRangeUnit);
    }

    /** How much faster than the middle the right wheel runs, and slower the left one, at this turn rate. */
    public double wheelMmPerSec(double degPerSec) {
        return Math.toRadians(degPerSec) / radPerMm;
    }

    public double turnDegPerSec(double wheelMmPerSec) {
        return Math.toDegrees(wheelMmPerSec * radPerMm);
    }
}
