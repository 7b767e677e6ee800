package majic.pioneer.state;

/**
 * Position and direction of a sonar disc in the robot's frame: x ahead of the turning centre, y to the left. Immutable.
 *
 * @param number as in the SIP
 * @param xMm position ahead, mm
 * @param yMm position to the left, mm
 * @param axisDeg direction, counterclockwise positive
 */
public record SonarDisc(int number, double xMm, double yMm, double axisDeg) {

    /** The array that it belongs to, 1 to 4. */
    int array() {
        return number / Equipment.DISCS_OF_AN_ARRAY + 1;
    }

    /** How far ahead an echo lies, mm. */
    public double echoX(double rangeMm) {
        return xMm + rangeMm * Math.cos(Math.toRadians(axisDeg));
    }

    /** How far to the left an echo lies, mm. */
    public double echoY(double rangeMm) {
        return yMm + rangeMm * Math.sin(Math.toRadians(axisDeg));
    }
}
