package majic.ros.message;

import com.fasterxml.jackson.databind.JsonNode;

/**
 * One turn of a laser scanner ({@code sensor_msgs/LaserScan}). Immutable. A range is known only if it is within the
 * scanner's own limits: {@code null}, 0 and everything outside may mean that nothing is in range, that something is too
 * near, or that the beam came back from nowhere, which servers that send {@code null} for all of these do not tell
 * apart.
 */
public final class LaserScanMessage {
    private final String frame;
    private final double firstDeg;
    private final double stepDeg;
    private final double leastMm;
    private final double reachMm;
    private final double[] measuredMm;

    private LaserScanMessage(
            String frame, double firstDeg, double stepDeg, double leastMm, double reachMm, double[] measuredMm) {
        this.frame = frame;
        this.firstDeg = firstDeg;
        this.stepDeg = stepDeg;
        this.leastMm = leastMm;
        this.reachMm = reachMm;
        this.measuredMm = measuredMm;
    }

    /**
     * Reads a message.
     *
     * @param message the content of a {@code sensor_msgs/LaserScan}
     * @return the scan
     * @throws UnusableMessage if the angles are not finite numbers, or the ranges are no list
     */
    public static LaserScanMessage from(JsonNode message) {
        JsonNode ranges = Fields.list(message, "ranges");
        double[] measuredMm = new double[ranges.size()];
        for (int beam = 0; beam < measuredMm.length; beam++) {
            measuredMm[beam] = RosUnits.mm(Fields.measured(ranges.get(beam)));
        }
        return new LaserScanMessage(
                Fields.frame(message, "header.frame_id"),
                Math.toDegrees(Fields.number(message, "angle_min")),
                Math.toDegrees(Fields.number(message, "angle_increment")),
                RosUnits.mm(Fields.optional(message, "range_min").orElse(0)),
                RosUnits.mm(Fields.optional(message, "range_max").orElse(Double.POSITIVE_INFINITY)),
                measuredMm);
    }

    /**
     * Returns the frame of the scanner.
     *
     * @return empty if the message names none
     */
    public String frame() {
        return frame;
    }

    /**
     * Returns the number of beams.
     *
     * @return 0 or more
     */
    public int beams() {
        return measuredMm.length;
    }

    /**
     * Returns the direction of a beam.
     *
     * @param beam from 0
     * @return degrees in the frame of the scanner, counterclockwise positive, not normalised
     */
    public double directionDeg(int beam) {
        return firstDeg + beam * stepDeg;
    }

    /**
     * Returns the angle from one beam to the next.
     *
     * @return degrees; negative for a scanner that sends its beams clockwise
     */
    public double stepDeg() {
        return stepDeg;
    }

    /**
     * Returns the least range that the scanner measures: what is nearer has no range.
     *
     * @return mm; 0 if it is not in the message
     */
    public double leastMm() {
        return leastMm;
    }

    /**
     * Returns the greatest range that the scanner measures.
     *
     * @return mm; infinite if it is not in the message
     */
    public double reachMm() {
        return reachMm;
    }

    /**
     * Returns what a beam measured.
     *
     * @param beam from 0
     * @return mm from the scanner; NaN if unknown
     */
    public double rangeMm(int beam) {
        double range = measuredMm[beam];
        return range > 0 && range >= leastMm && range <= reachMm && Double.isFinite(range) ? range : Double.NaN;
    }

    /**
     * Returns what the message has for a beam, also outside of the scanner's limits.
     *
     * @param beam from 0
     * @return mm, also infinite; NaN without a number
     */
    public double measuredMm(int beam) {
        return measuredMm[beam];
    }
}
