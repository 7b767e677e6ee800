package majic.hemisson.readings;

import java.util.OptionalDouble;

/**
 * How far the hull is from what the infra-red sensors see. An estimate: the readings depend on the material of the
 * obstacle.
 *
 * <p>The hull counts as a disc of 60 mm. Ahead, an obstacle counts if any of the five forward sensors sees it within
 * the strip that the disc will sweep, with its distance from the foremost point of the disc; so a wall met at a grazing
 * angle and the corner of a box beside the middle sensor are found in time. The strip is a little wider than the disc,
 * because the wheels never turn at the same speed.
 */
public final class Clearance {
    /** The radius of the hull, mm. */
    public static final double HULL_MM = 60;

    private static final double STRIP_MM = HULL_MM + 5;

    /** Where the sensors sit and look (Hemisson sheet 6): x, y in mm, direction in degrees. */
    private static final double[][] MOUNTS = {
        {57.5, 0, 0}, {51, -31, -38}, {51, 31, 38}, {10, -49, -90}, {10, 49, 90}, {-64, 0, 180},
    };

    private Clearance() {}

    /** Free way ahead, mm; empty when there is no obstacle in range. */
    public static OptionalDouble front(Proximity seen) {
        OptionalDouble nearest = OptionalDouble.empty();
        for (int sensor = Proximity.FRONT; sensor <= Proximity.LEFT; sensor++) {
            nearest = smaller(nearest, ahead(seen, sensor));
        }
        return nearest;
    }

    public static OptionalDouble left(Proximity seen) {
        return beyond(seen.distanceMm(Proximity.LEFT), HULL_MM - MOUNTS[Proximity.LEFT][1]);
    }

    public static OptionalDouble right(Proximity seen) {
        return beyond(seen.distanceMm(Proximity.RIGHT), HULL_MM + MOUNTS[Proximity.RIGHT][1]);
    }

    /** Behind; the rear sensor is the hindmost point of the robot. */
    public static OptionalDouble back(Proximity seen) {
        return seen.distanceMm(Proximity.REAR);
    }

    private static OptionalDouble ahead(Proximity seen, int sensor) {
        OptionalDouble distance = seen.distanceMm(sensor);
        if (distance.isEmpty()) {
            return distance;
        }
        double direction = Math.toRadians(MOUNTS[sensor][2]);
        double x = MOUNTS[sensor][0] + distance.getAsDouble() * Math.cos(direction);
        double y = MOUNTS[sensor][1] + distance.getAsDouble() * Math.sin(direction);
        return Math.abs(y) > STRIP_MM ? OptionalDouble.empty() : OptionalDouble.of(Math.max(0, x - HULL_MM));
    }

    private static OptionalDouble beyond(OptionalDouble distance, double hullMm) {
        return distance.isEmpty() ? distance : OptionalDouble.of(Math.max(0, distance.getAsDouble() - hullMm));
    }

    private static OptionalDouble smaller(OptionalDouble one, OptionalDouble other) {
        if (one.isEmpty() || other.isEmpty()) {
            return one.isEmpty() ? other : one;
        }
        return OptionalDouble.of(Math.min(one.getAsDouble(), other.getAsDouble()));
    }
}
