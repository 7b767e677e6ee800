package majic.ros.readings;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import majic.bot.Beam;
import majic.bot.Pose;
import majic.bot.RangeSensor;
import majic.ros.message.FrameTransform;
import majic.ros.message.LaserScanMessage;
import majic.ros.message.RangeMessage;
import majic.ros.message.Vector;

/**
 * The beams of a range sensor in its own frame, as its messages describe them. Immutable.
 *
 * @param frame of the sensor; empty if the messages name none
 * @param count the number of beams
 * @param firstDeg the direction of the first beam, counterclockwise positive
 * @param stepDeg from one beam to the next, counterclockwise positive
 * @param openingDeg the full angle of the cone of each
 * @param leastMm the least range that it measures
 * @param reachMm the greatest one
 * @param noiseMm the standard deviation of a range, which no message has
 */
record BeamLayout(
        String frame,
        int count,
        double firstDeg,
        double stepDeg,
        double openingDeg,
        double leastMm,
        double reachMm,
        double noiseMm) {
    /** By the data sheets of scanners such as LDS-01 and LMS 200: 10 to 15 mm within some metres. */
    private static final double LASER_NOISE_MM = 15;

    /** About 1 % of a distance; this is for one of 3 m. */
    private static final double SINGLE_NOISE_MM = 30;

    private static final double WIDEST_DEG = 180;

    /** Farther than any scanner in a building measures: the reach of one whose messages have none. */
    private static final double FARTHEST_MM = 100_000;

    /** The sine of the slope from which a beam is taken to meet the floor or the ceiling: 10 degrees. */
    private static final double STEEPEST = Math.sin(Math.toRadians(10));

    static BeamLayout of(LaserScanMessage scan) {
        return new BeamLayout(
                scan.frame(),
                scan.beams(),
                scan.directionDeg(0),
                scan.stepDeg(),
                Math.min(1, Math.abs(scan.stepDeg())),
                scan.leastMm(),
                scan.reachMm(),
                LASER_NOISE_MM);
    }

    static BeamLayout of(RangeMessage range) {
        double opening = Math.max(0, Math.min(WIDEST_DEG, range.openingDeg()));
        return new BeamLayout(range.frame(), 1, 0, 0, opening, range.leastMm(), range.reachMm(), SINGLE_NOISE_MM);
    }

    /**
     * Returns the sensor on the robot.
     *
     * @param name of the sensor
     * @param mount where its frame is on the robot
     * @return empty for one that measures no distances along the floor: without beams or with too many, without a
     *     reach, or tilted by more than 10 degrees, such as a cliff sensor
     */
    Optional<RangeSensor> sensor(String name, FrameTransform mount) {
        double least = Math.max(0, leastMm);
        double reach = Math.min(reachMm, FARTHEST_MM);
        if (count == 0 || count > RangeSensor.MOST_BEAMS || !(reach > least)) {
            return Optional.empty();
        }
        List<Beam> beams = new ArrayList<>(count);
        for (int beam = 0; beam < count; beam++) {
            double angle = Math.toRadians(firstDeg + beam * stepDeg);
            Vector along = mount.orientation().rotate(new Vector(Math.cos(angle), Math.sin(angle), 0));
            if (Math.abs(along.z()) > STEEPEST) {
                return Optional.empty();
            }
            double headingDeg = Math.toDegrees(Math.atan2(along.y(), along.x()));
            Pose place = new Pose(mount.originMm().x(), mount.originMm().y(), headingDeg);
            beams.add(new Beam(place, openingDeg, least, reach, noiseMm));
        }
        return Optional.of(new RangeSensor(name, beams));
    }
}
