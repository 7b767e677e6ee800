package majic.bot;

/**
 * The distances that a sensor has measured at one moment, with the odometry of that moment. Immutable.
 *
 * <p>A range is a distance in mm along its beam; {@link Float#POSITIVE_INFINITY} if there was no echo up to the reach
 * of the beam, {@link Float#NaN} if nothing was measured.
 */
public final class RangeScan {
    private final RangeSensor sensor;
    private final double timeS;
    private final Pose odometry;
    private final float[] rangesMm;

    /**
     * Makes a scan. A distance from the reach on is kept as no echo, one below the least distance of its beam as
     * nothing measured.
     *
     * @param sensor what has measured
     * @param timeS when, s, on any clock that the scans of a robot share
     * @param odometry the pose of the robot's centre at that time, in the frame of its odometry
     * @param rangesMm a range for each beam, mm; copied
     * @throws IllegalArgumentException if the number of ranges is not that of the beams, or the time is not finite
     */
    public RangeScan(RangeSensor sensor, double timeS, Pose odometry, float... rangesMm) {
        if (rangesMm.length != sensor.beams().size()) {
            throw new IllegalArgumentException("a scan of the " + sensor.name() + " has "
                    + sensor.beams().size() + " ranges, not " + rangesMm.length);
        }
        if (!Double.isFinite(timeS)) {
            throw new IllegalArgumentException("the time of a scan is finite, not " + timeS);
        }
        this.sensor = sensor;
        this.timeS = timeS;
        this.odometry = odometry;
        this.rangesMm = new float[rangesMm.length];
        for (int beam = 0; beam < rangesMm.length; beam++) {
            this.rangesMm[beam] = limited(sensor.beams().get(beam), rangesMm[beam]);
        }
    }

    private static float limited(Beam beam, float range) {
        if (range >= beam.reachMm()) {
            return Float.POSITIVE_INFINITY;
        }
        return range >= beam.leastMm() ? range : Float.NaN;
    }

    /** Returns what has measured. */
    public RangeSensor sensor() {
        return sensor;
    }

    /** Returns when it was measured, s. */
    public double timeS() {
        return timeS;
    }

    /** Returns the pose of the robot's centre at that time, in the frame of its odometry. */
    public Pose odometry() {
        return odometry;
    }

    /** Returns the number of ranges, which is that of the sensor's beams. */
    public int size() {
        return rangesMm.length;
    }

    /**
     * Returns a range.
     *
     * @param beam its index, from 0
     * @return mm, infinite for no echo, not a number for nothing measured
     */
    public float rangeMm(int beam) {
        return rangesMm[beam];
    }

    /**
     * Returns the same scan beside another odometry, for instance at the robot's place on a map.
     *
     * @param pose the pose of the robot's centre
     * @return the scan; it shares the ranges
     */
    public RangeScan at(Pose pose) {
        return new RangeScan(sensor, timeS, pose, rangesMm);
    }
}
