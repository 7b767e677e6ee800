package majic.mavlink.message;

import majic.mavlink.frame.Payload;

/**
 * An OBSTACLE_DISTANCE: distances in equal steps around the vehicle. Immutable.
 *
 * @param firstDeg the direction of the first one, to the left positive
 * @param stepDeg from one to the next, to the left positive
 * @param leastMm the shortest distance that is measured
 * @param mostMm the longest one
 * @param body whether directions are those of the vehicle, and not of the compass
 * @param payload the message
 */
public record ObstacleRing(double firstDeg, double stepDeg, int leastMm, int mostMm, boolean body, Payload payload) {
    /** How many distances there are. */
    public static final int COUNT = 72;

    private static final int BODY_FRAME = 12;
    private static final int UNKNOWN = 0xFFFF;
    private static final int MM_PER_CM = 10;
    private static final double WHOLE_TURN_DEG = 360;

    /** Reads the fields (MAVLink sheet 6). */
    public static ObstacleRing of(Payload payload) {
        double exact = payload.f32(158);
        double step = exact != 0 && Double.isFinite(exact) ? exact : payload.u8(157);
        double offset = payload.f32(162);
        return new ObstacleRing(
                Double.isFinite(offset) ? -offset : 0,
                -step,
                MM_PER_CM * payload.u16(152),
                MM_PER_CM * payload.u16(154),
                payload.u8(166) == BODY_FRAME,
                payload);
    }

    /** Whether its directions and limits make sense. */
    public boolean isUsable() {
        return body
                && mostMm > leastMm
                && stepDeg != 0
                && COUNT * Math.abs(stepDeg) <= WHOLE_TURN_DEG + COUNT
                && Math.abs(firstDeg) <= WHOLE_TURN_DEG;
    }

    /**
     * Returns a distance.
     *
     * @param index 0 to 71
     * @return mm; infinite where nothing is in reach, NaN where nothing was measured
     */
    public double mm(int index) {
        int cm = payload.u16(8 + 2 * index);
        if (cm == UNKNOWN) {
            return Double.NaN;
        }
        return MM_PER_CM * cm > mostMm ? Double.POSITIVE_INFINITY : MM_PER_CM * cm;
    }
}
