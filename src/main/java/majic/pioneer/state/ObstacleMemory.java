package majic.pioneer.state;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumMap;
import java.util.Iterator;
import java.util.Map;
import majic.bot.Pose;
import majic.pioneer.arcos.SonarReadings;

/**
 * What the sonars have heard of late, as points in the frame of the odometry, and how far off the hull they are.
 *
 * <p>A disc fires only every third of a second, sees walls at more than about 30° from square not at all, and loses an
 * echo now and then. So every echo counts for {@value #MEMORY_S} s, carried along with the robot's motion, and all
 * points count on every side whichever disc saw them. The price: what was taken away is still seen for that long. For one
 * thread.
 */
final class ObstacleMemory {
    /** How long an echo counts, seconds: four firings of a disc. */
    static final double MEMORY_S = 1.5;

    /** A disc without a reading for longer than its echoes count does not count as looking, seconds. */
    private static final double DISC_SILENCE_S = MEMORY_S;

    /** Wider lanes for the width of the cones: a wall seen from the edge of one seems farther aside than it is. */
    private static final double MARGIN_MM = 40;

    private final Model model;
    private final Deque<Echo> echoes = new ArrayDeque<>();

    /** A point where something was, in the odometry's frame. */
    private record Echo(double xMm, double yMm, long atNanos) {}

    ObstacleMemory(Model model) {
        this.model = model;
    }

    /** Takes the new readings in, heard from a pose. */
    void hear(SonarScan scan, SonarReadings readings, Pose pose, long nanos) {
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

    /** How far off the hull the nearest thing is on every side that all its discs have looked to. */
    Map<Side, Double> gaps(SonarScan scan, Pose pose, long nanos) {
        Map<Side, Double> gaps = new EnumMap<>(Side.class);
        for (Side side : Side.values()) {
            if (isKnown(side, scan, nanos)) {
                gaps.put(side, nearest(side, pose));
            }
        }
        return gaps;
    }

    private boolean isKnown(Side side, SonarScan scan, long nanos) {
        return model.discs().stream().anyMatch(side::isWatchedBy)
                && model.discs().stream()
                        .filter(side::isWatchedBy)
                        .allMatch(disc -> scan.hasHeard(disc.number())
                                && (nanos - scan.atNanos(disc.number())) / 1e9 <= DISC_SILENCE_S);
    }

    private double nearest(Side side, Pose pose) {
        double cos = Math.cos(Math.toRadians(pose.headingDeg()));
        double sin = Math.sin(Math.toRadians(pose.headingDeg()));
        double nearest = Double.POSITIVE_INFINITY;
        for (Echo echo : echoes) {
            double dx = echo.xMm() - pose.xMm();
            double dy = echo.yMm() - pose.yMm();
            double gap = side.gapMm(model.hull(), dx * cos + dy * sin, dy * cos - dx * sin, MARGIN_MM);
            nearest = Math.min(nearest, gap);
        }
        return nearest;
    }
}
