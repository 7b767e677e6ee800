package majic.nav.path;

import java.util.List;
import majic.bot.Fence;
import majic.bot.Pose;
import org.jspecify.annotations.Nullable;

/**
 * Where a robot fits: the obstacles of a map, and round things that are not on it, such as other robots or what its
 * sensors see. Immutable.
 *
 * @param map the distances from the obstacles of the map
 * @param bodyMm the radius of the robot
 * @param things what is not on the map
 * @param fence outside of which no way is planned; null without one
 */
public record FreeSpace(
        ObstacleDistance map,
        double bodyMm,
        List<Disc> things,
        @Nullable Fence fence) {
    /** A robot keeps as far from everything if it can, mm: what its odometry and its control are wrong by. */
    public static final double MARGIN_MM = 30;

    /**
     * Something round.
     *
     * @param xMm of its centre, in the frame of the map
     * @param yMm of its centre
     * @param radiusMm 0 or more
     */
    public record Disc(double xMm, double yMm, double radiusMm) {
        /**
         * Returns the distance of a place from it.
         *
         * @param x of the place, in the frame of the map
         * @param y of the place
         * @return mm; negative inside
         */
        public double distanceMm(double x, double y) {
            double dx = x - xMm;
            double dy = y - yMm;
            return Math.sqrt(dx * dx + dy * dy) - radiusMm;
        }
    }

    /** Keeps a copy of the things. */
    public FreeSpace {
        things = List.copyOf(things);
    }

    /**
     * A space without a fence.
     *
     * @param map the distances from the obstacles of the map
     * @param bodyMm the radius of the robot
     * @param things what is not on the map
     */
    public FreeSpace(ObstacleDistance map, double bodyMm, List<Disc> things) {
        this(map, bodyMm, things, null);
    }

    /**
     * Returns this space with other things.
     *
     * @param others what is not on the map
     * @return a space on the same map
     */
    public FreeSpace with(List<Disc> others) {
        return new FreeSpace(map, bodyMm, others, fence);
    }

    /**
     * Returns this space without its fence.
     *
     * @return a space with the same obstacles
     */
    public FreeSpace unfenced() {
        return new FreeSpace(map, bodyMm, things);
    }

    /**
     * Returns whether a way may lead through a place, by the fence alone.
     *
     * @param xMm of the robot's centre, in the frame of the map
     * @param yMm of the robot's centre
     * @return true without a fence
     */
    public boolean isInFence(double xMm, double yMm) {
        return fence == null || fence.insideMm(xMm, yMm) >= 0;
    }

    /**
     * Returns how far the hull of the robot would be from the nearest obstacle.
     *
     * @param xMm of the robot's centre, in the frame of the map
     * @param yMm of the robot's centre
     * @return mm; negative if it would touch
     */
    public double mm(double xMm, double yMm) {
        double nearest = map.mm(xMm, yMm) - map.grid().cellMm() / 2;
        for (Disc thing : things) {
            nearest = Math.min(nearest, thing.distanceMm(xMm, yMm));
        }
        return nearest - bodyMm;
    }

    /**
     * Returns how far the robot can drive along an arc until it would come too close to something.
     *
     * @param from where it is
     * @param degPerMm how the arc bends, counterclockwise positive
     * @param mostMm how far to look
     * @return mm; 0 if it cannot begin, at most {@code mostMm}
     */
    public double freeMm(Pose from, double degPerMm, double mostMm) {
        return freeMm(from, degPerMm, mostMm, Math.min(map.grid().cellMm(), MARGIN_MM));
    }

    /**
     * Returns how far the robot can drive along an arc, as {@link #freeMm(Pose, double, double)} does.
     *
     * @param from where it is
     * @param degPerMm how the arc bends, counterclockwise positive
     * @param mostMm how far to look
     * @param stepMm how far the places that are looked at are apart
     * @return mm; 0 if it cannot begin, at most {@code mostMm}
     */
    public double freeMm(Pose from, double degPerMm, double mostMm, double stepMm) {
        double least = Math.min(MARGIN_MM / 2, mm(from.xMm(), from.yMm()) - 1);
        Pose at = from;
        for (double way = 0; way < mostMm; way += stepMm) {
            at = at.after(stepMm, stepMm * degPerMm);
            double space = mm(at.xMm(), at.yMm());
            if (space < least) {
                return way;
            }
            least = Math.min(MARGIN_MM / 2, Math.max(least, space));
        }
        return mostMm;
    }
}
