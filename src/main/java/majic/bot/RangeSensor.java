package majic.bot;

import java.util.List;
import java.util.stream.IntStream;

/**
 * A sensor that measures distances along beams, such as a laser scanner or a ring of sonars: what it is called and
 * where its beams are, once for all scans. Immutable.
 *
 * @param name as a user reads it, such as {@code laser}; each sensor of a robot has its own
 * @param beams in the order of the ranges of a scan, 1 to {@value #MOST_BEAMS}
 */
public record RangeSensor(String name, List<Beam> beams) {
    /** The most beams of a sensor. */
    public static final int MOST_BEAMS = 8192;

    private static final int LEAST_LASER_BEAMS = 30;
    private static final double WIDEST_LASER_DEG = 5;

    /** Refuses a sensor without a beam, or with too many. */
    public RangeSensor {
        beams = List.copyOf(beams);
        if (beams.isEmpty() || beams.size() > MOST_BEAMS) {
            throw new IllegalArgumentException("a range sensor has 1 to " + MOST_BEAMS + " beams, not " + beams.size());
        }
    }

    /**
     * Returns a laser scanner whose beams begin at one place and are equally far apart.
     *
     * @param mount its place in the robot's frame, and the direction of its angle 0
     * @param count the number of beams
     * @param firstDeg the angle of the first beam, counterclockwise positive
     * @param stepDeg from one beam to the next, counterclockwise positive; also the opening of each
     * @param reachMm the longest distance that it measures
     * @param noiseMm the standard deviation of a measured distance
     * @return the sensor
     */
    public static RangeSensor laser(
            Pose mount, int count, double firstDeg, double stepDeg, double reachMm, double noiseMm) {
        double opening = Math.min(Math.abs(stepDeg), 1);
        return new RangeSensor(
                "laser",
                IntStream.range(0, count)
                        .mapToObj(beam -> new Beam(
                                mount.plus(new Pose(0, 0, firstDeg + beam * stepDeg)), opening, 0, reachMm, noiseMm))
                        .toList());
    }

    /**
     * Returns whether its scans say enough to find the place of the robot by them, as those of a laser scanner.
     *
     * @return true for at least {@value #LEAST_LASER_BEAMS} beams that are at most {@value #WIDEST_LASER_DEG} degrees
     *     wide
     */
    public boolean isLaser() {
        return beams.size() >= LEAST_LASER_BEAMS
                && beams.stream().allMatch(beam -> beam.openingDeg() <= WIDEST_LASER_DEG);
    }
}
