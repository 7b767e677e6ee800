package majic.mavlink.message;

import majic.mavlink.frame.Payload;

/**
 * A DISTANCE_SENSOR. Immutable.
 *
 * @param id of the sensor
 * @param orientation where it looks, as MAV_SENSOR_ORIENTATION numbers it
 * @param leastMm the shortest distance that it measures
 * @param mostMm the longest one
 * @param mm measured
 */
public record RangeReading(int id, int orientation, int leastMm, int mostMm, int mm) {
    private static final int HORIZONTAL = 8;
    private static final double STEP_DEG = 45;
    private static final int MM_PER_CM = 10;

    /** Reads the fields (MAVLink sheet 6). */
    public static RangeReading of(Payload payload) {
        return new RangeReading(
                payload.u8(11),
                payload.u8(12),
                MM_PER_CM * payload.u16(4),
                MM_PER_CM * payload.u16(6),
                MM_PER_CM * payload.u16(8));
    }

    /** Whether it looks to a side of the vehicle, and not up or down, and its limits make sense. */
    public boolean isHorizontal() {
        return orientation < HORIZONTAL && mostMm > leastMm;
    }

    /** Returns where it looks: degrees, to the left positive. */
    public double directionDeg() {
        return -STEP_DEG * orientation;
    }
}
