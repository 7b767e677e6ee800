package majic.mavlink.message;

import majic.mavlink.frame.Payload;

/**
 * A GLOBAL_POSITION_INT. Immutable.
 *
 * @param latitudeE7 1e-7 degrees, north positive
 * @param longitudeE7 1e-7 degrees, east positive
 * @param aboveHomeMm height above the home position, mm
 * @param northMmPerSec velocity to the north, mm/s
 * @param eastMmPerSec velocity to the east, mm/s
 * @param downMmPerSec velocity downward, mm/s
 */
public record GlobalPosition(
        int latitudeE7,
        int longitudeE7,
        int aboveHomeMm,
        double northMmPerSec,
        double eastMmPerSec,
        double downMmPerSec) {
    private static final double EARTH_RADIUS_MM = 6_371_000_000.0;

    /** Reads the fields (MAVLink sheet 6). */
    public static GlobalPosition of(Payload payload) {
        return new GlobalPosition(
                payload.i32(4),
                payload.i32(8),
                payload.i32(16),
                10.0 * payload.i16(20),
                10.0 * payload.i16(22),
                10.0 * payload.i16(24));
    }

    /** Whether there is a fix: both angles are zero before. */
    public boolean isKnown() {
        return latitudeE7 != 0 || longitudeE7 != 0;
    }

    /**
     * Returns the distance to a place, on a plane.
     *
     * @param toLatitudeE7 1e-7 degrees
     * @param toLongitudeE7 1e-7 degrees
     * @return mm
     */
    public double distanceMm(int toLatitudeE7, int toLongitudeE7) {
        return Math.hypot(northMm(toLatitudeE7), eastMm(toLongitudeE7));
    }

    /**
     * Returns how far to the north a latitude is.
     *
     * @param toLatitudeE7 1e-7 degrees
     * @return mm
     */
    public double northMm(int toLatitudeE7) {
        return EARTH_RADIUS_MM * Math.toRadians((toLatitudeE7 - (double) latitudeE7) / 1e7);
    }

    /**
     * Returns how far to the east a longitude is, on a plane.
     *
     * @param toLongitudeE7 1e-7 degrees
     * @return mm
     */
    public double eastMm(int toLongitudeE7) {
        double degEast = Math.IEEEremainder((toLongitudeE7 - (double) longitudeE7) / 1e7, 360);
        return EARTH_RADIUS_MM * Math.toRadians(degEast) * Math.cos(Math.toRadians(latitudeE7 / 1e7));
    }
}
