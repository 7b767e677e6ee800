package majicsim.mavlink;

import majicsim.world.Noise;

/**
 * The position that the vehicle believes in: the true one plus the error of the satellites, which wanders by some 0.1
 * to 0.3 m without end, at up to 40 mm/s: of a vehicle that stands the filter reports that velocity (recorded session).
 * Places are in m north and east of the middle of the room, which is at a fixed place on the globe.
 */
final class PositionFilter {
    /** The height of the floor above the sea, m. */
    static final double FLOOR_M = 584;

    private static final double LATITUDE = -35.3632620;
    private static final double LONGITUDE = 149.1652370;
    private static final double METRES_A_UNIT = 0.011131884502145034;
    private static final double UNITS = 1e7;
    private static final long SAMPLE_NANOS = 200_000_000;
    private static final double SAMPLE_S = 0.2;
    private static final double FADING_S = 20;
    private static final double DRIFT_FADING_S = 2;
    private static final double DRIFT_SIGMA_M_PER_S = 0.015;
    private static final double LARGEST_M = 0.3;

    private final Noise noise;
    private long sampleNanos;
    private double errorNorth;
    private double errorEast;
    private double driftNorth;
    private double driftEast;
    private double originNorth;
    private double originEast;
    private double homeNorth;
    private double homeEast;
    private double homeHeight;

    PositionFilter(Noise noise) {
        this.noise = noise;
    }

    /** The error changes five times a second, as new fixes come. */
    void step(double seconds) {
        sampleNanos += Math.round(seconds * 1e9);
        while (sampleNanos >= SAMPLE_NANOS) {
            sampleNanos -= SAMPLE_NANOS;
            driftNorth = drifted(driftNorth);
            driftEast = drifted(driftEast);
            errorNorth = wandered(errorNorth, driftNorth);
            errorEast = wandered(errorEast, driftEast);
        }
    }

    private double drifted(double drift) {
        double kept = Math.exp(-SAMPLE_S / DRIFT_FADING_S);
        return drift * kept + noise.gaussian(DRIFT_SIGMA_M_PER_S * Math.sqrt(1 - kept * kept));
    }

    private static double wandered(double error, double drift) {
        double next = error * Math.exp(-SAMPLE_S / FADING_S) + drift * SAMPLE_S;
        return Math.max(-LARGEST_M, Math.min(LARGEST_M, next));
    }

    /** How fast the vehicle goes to the north, m/s; a growing error looks like a motion. */
    double northSpeed(Motion at) {
        return at.northSpeed() + driftNorth;
    }

    /** The same to the east. */
    double eastSpeed(Motion at) {
        return at.eastSpeed() + driftEast;
    }

    /** In how many ns the next fix comes. */
    long dueNanos() {
        return SAMPLE_NANOS - sampleNanos;
    }

    void origin(Motion at) {
        originNorth = at.north();
        originEast = at.east();
    }

    void home(Motion at) {
        homeNorth = at.north();
        homeEast = at.east();
        homeHeight = at.height();
    }

    /** Metres north of the origin. */
    double north(Motion at) {
        return at.north() + errorNorth - originNorth;
    }

    /** Metres east of the origin. */
    double east(Motion at) {
        return at.east() + errorEast - originEast;
    }

    double homeNorth() {
        return homeNorth - originNorth;
    }

    double homeEast() {
        return homeEast - originEast;
    }

    double homeHeight() {
        return homeHeight;
    }

    /** The latitude of a place so far north of the origin, 1e-7 degrees. */
    int latitude(double north) {
        return (int) Math.round(LATITUDE * UNITS + (north + originNorth) / METRES_A_UNIT);
    }

    /** The longitude of a place so far east of the origin, 1e-7 degrees. */
    int longitude(double east) {
        return (int) Math.round(LONGITUDE * UNITS + (east + originEast) / (METRES_A_UNIT * shrinking()));
    }

    /** Metres north of the origin. */
    double northOf(double latitude) {
        return (latitude - LATITUDE * UNITS) * METRES_A_UNIT - originNorth;
    }

    /** Metres east of the origin. */
    double eastOf(double longitude) {
        return (longitude - LONGITUDE * UNITS) * METRES_A_UNIT * shrinking() - originEast;
    }

    private static double shrinking() {
        return Math.cos(Math.toRadians(LATITUDE));
    }
}
