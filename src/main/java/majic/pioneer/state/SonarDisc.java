package majic.pioneer.state;

/**
 * Where a sonar disc sits and looks, in the robot's frame: x ahead of the turning centre, y to the left. Immutable.
 *
 * @param number as in the SIP
 * @param xMm its place ahead, mm
 * @param yMm its place to the left, mm
 * @param axisDeg where it looks, counterclockwise positive
 */
public record SonarDisc(int number, double xMm, double yMm, double axisDeg) {

    /** How far ahead an echo lies, mm. */
    public double echoX(double rangeMm) {
        return xMm + rangeMm * Math.cos(Math.toRadians(axisDeg));
    }

    /** How far to the left an echo lies, mm. */
    public double echoY(double rangeMm) {
        return yMm + rangeMm * Math.sin(Math.toRadians(axisDeg));
    }
}
