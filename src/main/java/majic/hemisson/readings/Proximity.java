package majic.hemisson.readings;

import java.util.List;
import java.util.OptionalDouble;

/**
 * The eight infra-red proximity readings, 0 to 255, large when near, in the order of the robot's answer (Hemisson sheet
 * 6): front, front right, front left, right, left, rear, ground right, ground left. Immutable.
 *
 * @param raw as they came, but single spikes of noise taken out
 */
public record Proximity(List<Integer> raw) {
    static final int FRONT = 0;
    static final int FRONT_RIGHT = 1;
    static final int FRONT_LEFT = 2;
    static final int RIGHT = 3;
    static final int LEFT = 4;
    static final int REAR = 5;
    public static final int GROUND_RIGHT = 6;
    public static final int GROUND_LEFT = 7;
    public static final int SENSORS = 8;

    /** A reading below zero wraps round to this and above; no other cause occurs away from a wall. */
    private static final int WRAPPED = 250;

    /** What a reading just before a true {@link #WRAPPED} must have been at least. */
    private static final int VERY_NEAR = 100;

    /** Readings up to this occur with nothing in range. */
    private static final int NOTHING = 4;

    private static final int[] VALUES = {250, 150, 48, 20, 13, 8, 5};
    private static final double MM_PER_STEP = 10;

    public Proximity {
        raw = List.copyOf(raw);
    }

    /** The next readings; a sensor that jumps from far away to the maximum counts as seeing nothing. */
    public Proximity next(List<Integer> readings) {
        Integer[] clean = new Integer[SENSORS];
        for (int sensor = 0; sensor < SENSORS; sensor++) {
            int value = readings.get(sensor);
            boolean noise = value >= WRAPPED && sensor < GROUND_RIGHT && raw.get(sensor) < VERY_NEAR;
            clean[sensor] = noise ? 0 : value;
        }
        return new Proximity(List.of(clean));
    }

    public int value(int sensor) {
        return raw.get(sensor);
    }

    /**
     * How far the sensor is from what it sees, if that is a white surface (sheet 6, typical response); a dark one seems
     * farther.
     *
     * @return 0 to 60 mm; empty when nothing is in range
     */
    public OptionalDouble distanceMm(int sensor) {
        int value = value(sensor);
        if (value <= NOTHING) {
            return OptionalDouble.empty();
        }
        int step = 0;
        while (step < VALUES.length - 1 && value < VALUES[step]) {
            step++;
        }
        if (step == 0) {
            return OptionalDouble.of(0);
        }
        double within = (double) (VALUES[step - 1] - value) / (VALUES[step - 1] - VALUES[step]);
        return OptionalDouble.of(MM_PER_STEP * (step - 1 + within));
    }

    /** The left ground reading without the firmware's slip, which subtracts from the right one's light (sheet 6). */
    public static int correctedGroundLeft(int proximity, int lightRight, int lightLeft) {
        return Math.floorMod(proximity - lightRight + lightLeft, 256);
    }
}
