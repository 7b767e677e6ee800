package majic.aibo.body;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.Optional;
import majic.bot.Pose;

/**
 * The obstacles that the infra-red sensors detected recently, and the distance of the nearest one ahead of the hull.
 * Each beam is much narrower than the dog, so obstacles are kept for the time of a sweep of the head, in the frame of
 * the dead reckoning, and all in the corridor that the dog needs count. Thread-safe.
 */
final class RecentObstacles {
    /** The beams start here, ahead of the turning centre. */
    static final double HEAD_AHEAD_MM = 120;

    /** The foremost part of the dog, ahead of the turning centre. */
    static final double HULL_AHEAD_MM = 150;

    /** Half the way the dog needs: it fits in a circle of 180 mm radius and turns inside of it, plus a margin. */
    static final double CORRIDOR_HALF_MM = 200;

    /** For how long a hit counts: more than one sweep. */
    private static final long KEPT_MS = 2500;

    private record Hit(double xMm, double yMm, long serverMs) {}

    private final Deque<Hit> hits = new ArrayDeque<>();

    /**
     * Adds the reading of one beam: the pose of the dog, the direction of the beam, and its range if it detected an
     * obstacle.
     */
    synchronized void add(Pose dog, double panDeg, Optional<Double> rangeMm, long serverMs) {
        forget(serverMs);
        rangeMm.ifPresent(range -> {
            double heading = Math.toRadians(dog.headingDeg());
            double beam = Math.toRadians(dog.headingDeg() + panDeg);
            double x = dog.xMm() + HEAD_AHEAD_MM * Math.cos(heading) + range * Math.cos(beam);
            double y = dog.yMm() + HEAD_AHEAD_MM * Math.sin(heading) + range * Math.sin(beam);
            hits.addLast(new Hit(x, y, serverMs));
        });
    }

    /** The nearest thing in the corridor ahead, mm from the hull and not below 0; empty if there is none. */
    synchronized Optional<Double> frontMm(Pose dog) {
        double cos = Math.cos(Math.toRadians(dog.headingDeg()));
        double sin = Math.sin(Math.toRadians(dog.headingDeg()));
        double nearest = Double.POSITIVE_INFINITY;
        for (Hit hit : hits) {
            double dx = hit.xMm - dog.xMm();
            double dy = hit.yMm - dog.yMm();
            double ahead = dx * cos + dy * sin;
            double aside = Math.abs(dy * cos - dx * sin);
            if (ahead > 0 && aside <= CORRIDOR_HALF_MM) {
                nearest = Math.min(nearest, Math.max(0, ahead - HULL_AHEAD_MM));
            }
        }
        return Double.isInfinite(nearest) ? Optional.empty() : Optional.of(nearest);
    }

    synchronized void clear() {
        hits.clear();
    }

    private void forget(long serverMs) {
        for (Iterator<Hit> all = hits.iterator(); all.hasNext(); ) {
            if (Math.abs(serverMs - all.next().serverMs) > KEPT_MS) {
                all.remove();
            }
        }
    }
}
