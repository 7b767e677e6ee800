package majicsim.pioneer.devices;

/**
 * The compass as the SIP shows it: units of 2 degrees clockwise from north, and north is where the room's y axis
 * points.
 */
public final class Compass {
    private static final double DEG_PER_UNIT = 2;
    private static final int UNITS_PER_TURN = 180;
    private static final double NORTH_DEG = 90;

    private boolean on = true;

    /** TCM2: 0 switches it off. */
    public void enable(boolean enabled) {
        on = enabled;
    }

    /** 1 to 180, due north being 180, as 0 means that there is none (ARCOS sheet 8, 17). */
    public int reading(double headingDeg) {
        if (!on) {
            return 0;
        }
        int units = Math.floorMod(Math.round((NORTH_DEG - headingDeg) / DEG_PER_UNIT), UNITS_PER_TURN);
        return units == 0 ? UNITS_PER_TURN : units;
    }
}
