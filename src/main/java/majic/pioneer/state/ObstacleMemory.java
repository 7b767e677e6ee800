package majic.pioneer.state;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.EnumMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import majic.bot.Pose;
import majic.pioneer.arcos.SonarReadings;

/**
 * The recent echoes of the sonars as points in the frame of the odometry, and their distances from the hull.
 *
 * <p>A disc fires only every third of a second, gets no echo of walls at more than about 30° from square, and loses an echo
 * now and then. So every echo is kept for {@value #MEMORY_S} s at its place on the floor, and every point counts on each
 * side, whichever disc detected it. In return an obstacle that was removed is reported for that long. For one thread.
 */
final class ObstacleMemory {
    /** How long an echo is kept, seconds: four firings of a disc. */
    static final double MEMORY_S = 1.5;

    /** A disc without a reading for so long counts as off, seconds. */
    private static final double DISC_SILENCE_S = MEMORY_S;

    /** Added to the path for the width of the cones: a wall detected at the edge of a cone seems farther aside than it is. */
    private static final double MARGIN_MM = 40;

    private static final Side[] SIDES = Side.values();

    private final Model model;
    private final Map<Side, List<SonarDisc>> covering = new EnumMap<>(Side.class);
    private final Deque<Echo> echoes = new ArrayDeque<>();

    /** A point of an obstacle, in the frame of the odometry. */
    private record Echo(double xMm, double yMm, long atNanos) {}

    ObstacleMemory(Model model) {
        this.model = model;
        for (Side side : Side.values()) {
            covering.put(side, model.discs().stream().filter(side::isCoveredBy).toList());
        }
    }

    /** Adds the new readings, taken at a pose. */
    void add(SonarScan scan, SonarReadings readings, Pose pose, long nanos) {
        forget(nanos);
        double cos = Math.cos(Math.toRadians(pose.headingDeg()));
        double sin = Math.sin(Math.toRadians(pose.headingDeg()));
        for (SonarDisc disc : model.discs()) {
            int range = scan.rangeMm(disc.number());
            if (isNew(readings, disc.number()) && range < SonarScan.NOTHING_MM) {
                double x = disc.echoX(range);
                double y = disc.echoY(range);
                echoes.add(new Echo(pose.xMm() + x * cos - y * sin, pose.yMm() + x * sin + y * cos, nanos));
            }
        }
    }

    private static boolean isNew(SonarReadings readings, int disc) {
        for (int index = 0; index < readings.count(); index++) {
            if (readings.disc(index) == disc) {
                return true;
            }
        }
        return false;
    }

    private void forget(long nanos) {
        Iterator<Echo> oldest = echoes.iterator();
        while (oldest.hasNext() && (nanos - oldest.next().atNanos()) / 1e9 > MEMORY_S) {
            oldest.remove();
        }
    }

    /** The distance from the hull to the nearest obstacle, mm, on every side whose discs have all had a recent reading. */
    Map<Side, Double> gaps(SonarScan scan, Pose pose, long nanos) {
        double[] nearest = nearest(pose);
        Map<Side, Double> gaps = new EnumMap<>(Side.class);
        covering.forEach((side, discs) -> {
            if (isKnown(discs, scan, nanos)) {
                gaps.put(side, nearest[side.ordinal()]);
            }
        });
        return gaps;
    }

    private static boolean isKnown(List<SonarDisc> discs, SonarScan scan, long nanos) {
        for (SonarDisc disc : discs) {
            if (!scan.hasReading(disc.number()) || (nanos - scan.atNanos(disc.number())) / 1e9 > DISC_SILENCE_S) {
                return false;
            }
        }
        return !discs.isEmpty();
    }

    /** The distances of all sides, by ordinal number; each echo is converted to the robot's frame once. */
    private double[] nearest(Pose pose) {
        double cos = Math.cos(Math.toRadians(pose.headingDeg()));
        double sin = Math.sin(Math.toRadians(pose.headingDeg()));
        double[] nearest = new double[SIDES.length];
        Arrays.fill(nearest, Double.POSITIVE_INFINITY);
        for (Echo echo : echoes) {
            double dx = echo.xMm() - pose.xMm();
            double dy = echo.yMm() - pose.yMm();
            double x = dx * cos + dy * sin;
            double y = dy * cos - dx * sin;
            for (int side = 0; side < SIDES.length; side++) {
                nearest[side] = Math.min(nearest[side], SIDES[side].gapMm(model.hull(), x, y, MARGIN_MM));
            }
        }
        return nearest;
    }
}
