package majic.figures.nav;

import java.util.ArrayList;
import java.util.List;
import majic.bot.Pose;
import majic.lab.LabAccess.Wall;

/**
 * The length of the shortest way of a round robot between walls, computed without the planner that is measured: by a
 * visibility graph of points around the ends of the walls (Lozano-Pérez and Wesley 1979). Ways around a corner are
 * those of a polygon with {@value #POINTS} corners. Other robots are left out.
 */
final class ShortestWays {
    private static final int POINTS = 12;
    private static final double LEAST_MM = 1;

    private final List<Wall> walls;
    private final double bodyMm;
    private final List<Pose> points = new ArrayList<>();

    /** The length from each point to each other one; infinite if they do not see each other. */
    private final double[][] lengths;

    ShortestWays(List<Wall> walls, double bodyMm) {
        this.walls = walls;
        this.bodyMm = bodyMm;
        for (Wall wall : walls) {
            addAround(wall.x1(), wall.y1());
            addAround(wall.x2(), wall.y2());
        }
        lengths = new double[points.size()][points.size()];
        for (int one = 0; one < points.size(); one++) {
            for (int other = 0; other < one; other++) {
                lengths[one][other] = straightMm(points.get(one), points.get(other), bodyMm);
                lengths[other][one] = lengths[one][other];
            }
        }
    }

    private void addAround(double xMm, double yMm) {
        double away = (bodyMm + LEAST_MM) / Math.cos(Math.PI / POINTS);
        Pose end = new Pose(xMm, yMm, 0);
        if (points.stream().anyMatch(point -> Math.abs(point.distanceMm(end) - away) < LEAST_MM / 100)) {
            return;
        }
        for (int index = 0; index < POINTS; index++) {
            double angle = 2 * Math.PI * index / POINTS;
            Pose point = new Pose(xMm + away * Math.cos(angle), yMm + away * Math.sin(angle), 0);
            if (roomMm(point) >= bodyMm) {
                points.add(point);
            }
        }
    }

    private double roomMm(Pose place) {
        return walls.stream().mapToDouble(wall -> distanceMm(place, wall)).min().orElse(Double.POSITIVE_INFINITY);
    }

    /**
     * Returns the length of the shortest way; infinite if there is none.
     *
     * @param from may be closer to a wall than the robot is wide
     * @param to may be too
     */
    double mm(Pose from, Pose to) {
        double[] toEnd = new double[points.size()];
        double[] best = new double[points.size()];
        double fromRoom = Math.min(bodyMm, roomMm(from) - LEAST_MM);
        double toRoom = Math.min(bodyMm, roomMm(to) - LEAST_MM);
        for (int index = 0; index < best.length; index++) {
            best[index] = straightMm(from, points.get(index), fromRoom);
            toEnd[index] = straightMm(points.get(index), to, toRoom);
        }
        double shortest = straightMm(from, to, Math.min(fromRoom, toRoom));
        boolean[] done = new boolean[best.length];
        for (int at = nearest(best, done); at >= 0 && best[at] < shortest; at = nearest(best, done)) {
            done[at] = true;
            shortest = Math.min(shortest, best[at] + toEnd[at]);
            for (int next = 0; next < best.length; next++) {
                best[next] = Math.min(best[next], best[at] + lengths[at][next]);
            }
        }
        return shortest;
    }

    private static int nearest(double[] best, boolean[] done) {
        int nearest = -1;
        for (int index = 0; index < best.length; index++) {
            if (!done[index] && (nearest < 0 || best[index] < best[nearest])) {
                nearest = index;
            }
        }
        return nearest;
    }

    private double straightMm(Pose from, Pose to, double roomMm) {
        boolean free = walls.stream().noneMatch(wall -> isNear(from, to, wall, roomMm));
        return free ? from.distanceMm(to) : Double.POSITIVE_INFINITY;
    }

    private static boolean isNear(Pose from, Pose to, Wall wall, double roomMm) {
        if (Math.max(from.xMm(), to.xMm()) < Math.min(wall.x1(), wall.x2()) - roomMm
                || Math.min(from.xMm(), to.xMm()) > Math.max(wall.x1(), wall.x2()) + roomMm
                || Math.max(from.yMm(), to.yMm()) < Math.min(wall.y1(), wall.y2()) - roomMm
                || Math.min(from.yMm(), to.yMm()) > Math.max(wall.y1(), wall.y2()) + roomMm) {
            return false;
        }
        Pose first = new Pose(wall.x1(), wall.y1(), 0);
        Pose last = new Pose(wall.x2(), wall.y2(), 0);
        return cross(from, to, first) * cross(from, to, last) < 0
                        && cross(first, last, from) * cross(first, last, to) < 0
                || distanceMm(from, wall) < roomMm
                || distanceMm(to, wall) < roomMm
                || distanceMm(first, new Wall(from.xMm(), from.yMm(), to.xMm(), to.yMm())) < roomMm
                || distanceMm(last, new Wall(from.xMm(), from.yMm(), to.xMm(), to.yMm())) < roomMm;
    }

    /** Twice the area of a triangle, negative if it is clockwise. */
    private static double cross(Pose one, Pose two, Pose three) {
        return (two.xMm() - one.xMm()) * (three.yMm() - one.yMm())
                - (two.yMm() - one.yMm()) * (three.xMm() - one.xMm());
    }

    private static double distanceMm(Pose place, Wall line) {
        double dx = line.x2() - line.x1();
        double dy = line.y2() - line.y1();
        double square = dx * dx + dy * dy;
        double along = (place.xMm() - line.x1()) * dx + (place.yMm() - line.y1()) * dy;
        double share = square == 0 ? 0 : Math.max(0, Math.min(1, along / square));
        double beside = place.xMm() - line.x1() - share * dx;
        double above = place.yMm() - line.y1() - share * dy;
        return Math.sqrt(beside * beside + above * above);
    }
}
