package majicsim.pioneer.model;

/**
 * One sonar transducer (ARCOS sheet 12), seen from the turning centre.
 *
 * @param number 0 to 31, as the SIP names it; eight in a row belong to one array
 * @param xMm ahead
 * @param yMm to the left
 * @param axisDeg where it looks, counterclockwise
 */
public record SonarDisc(int number, double xMm, double yMm, double axisDeg) {
    /** Numbers are below this. */
    public static final int MOST = 32;

    private static final int DISCS_PER_ARRAY = 8;

    /** The array it belongs to, from 0: front, rear, upper front, upper rear. */
    int array() {
        return number / DISCS_PER_ARRAY;
    }
}
