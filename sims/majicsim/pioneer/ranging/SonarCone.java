package majicsim.pioneer.ranging;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import majicsim.pioneer.model.SonarDisc;
import majicsim.world.Body;
import majicsim.world.Hit;
import majicsim.world.Noise;
import majicsim.world.Point;
import majicsim.world.Pose;
import majicsim.world.World;

/**
 * What one sonar disc measures: the nearest echo in a cone of 30 degrees. A flat surface throws sound back only when it is
 * hit within about 30 degrees of perpendicular, beyond that the echo is lost; edges and corners scatter it and are detected from
 * near by in any direction.
 */
public final class SonarCone {
    /** No echo (ARCOS sheet 8.2). */
    static final double SILENCE_MM = 5000;

    private static final double NEAREST_MM = 100;
    private static final double HALF_CONE_DEG = 15;
    private static final double BETWEEN_RAYS_DEG = 5;
    private static final double LOST_BEYOND_DEG = 30;
    private static final double LOST_SIGMA_DEG = 2;
    private static final double RANGE_SIGMA = 0.01;
    private static final double EDGE_HEARD_MM = 2500;
    /** How much nearer something may be hit on the way to an edge that still counts as in sight. */
    private static final double EDGE_SLACK_MM = 2;

    private final World world;
    private final Body body;
    private final Noise noise;
    private final List<Point> wallEnds;

    public SonarCone(World world, Body body, Noise noise) {
        this.world = world;
        this.body = body;
        this.noise = noise;
        this.wallEnds = world.room().walls().stream()
                .flatMap(wall -> Stream.of(new Point(wall.x1(), wall.y1()), new Point(wall.x2(), wall.y2())))
                .distinct()
                .toList();
    }

    /** The range in mm from the disc, 100 to 5000; 5000 without an echo. */
    double rangeMm(SonarDisc disc) {
        Point at = body.pose().toWorld(disc.xMm(), disc.yMm());
        Pose view = new Pose(at.xMm(), at.yMm(), body.pose().toWorldDeg(disc.axisDeg()));
        double nearest = Math.min(surfaceMm(view), edgeMm(view));
        if (nearest >= SILENCE_MM) {
            return SILENCE_MM;
        }
        return Math.max(NEAREST_MM, Math.min(SILENCE_MM, nearest * noise.scale(RANGE_SIGMA)));
    }

    private double surfaceMm(Pose view) {
        double heardWithinDeg = LOST_BEYOND_DEG + noise.gaussian(LOST_SIGMA_DEG);
        double nearest = SILENCE_MM;
        for (double aside = -HALF_CONE_DEG; aside <= HALF_CONE_DEG; aside += BETWEEN_RAYS_DEG) {
            Hit hit = world.ray(body, view.xMm(), view.yMm(), view.headingDeg() + aside, Math.max(1, nearest));
            if (hit.found() && hit.incidenceDeg() <= heardWithinDeg) {
                nearest = hit.distanceMm();
            }
        }
        return nearest;
    }

    private double edgeMm(Pose view) {
        return edges().stream()
                .filter(edge -> isInCone(view, edge))
                .filter(edge -> isInSight(view, edge))
                .mapToDouble(edge -> distance(view, edge))
                .min()
                .orElse(SILENCE_MM);
    }

    private List<Point> edges() {
        List<Point> edges = new ArrayList<>(wallEnds);
        for (Body other : world.bodies()) {
            if (other != body) {
                edges.addAll(other.outline());
            }
        }
        return edges;
    }

    private static boolean isInCone(Pose view, Point edge) {
        double distanceMm = distance(view, edge);
        return distanceMm > 0
                && distanceMm < EDGE_HEARD_MM
                && Math.abs(Pose.normalised(bearingDeg(view, edge) - view.headingDeg())) <= HALF_CONE_DEG;
    }

    private boolean isInSight(Pose view, Point edge) {
        double distanceMm = distance(view, edge);
        Hit hit = world.ray(body, view.xMm(), view.yMm(), bearingDeg(view, edge), distanceMm);
        return !hit.found() || hit.distanceMm() > distanceMm - EDGE_SLACK_MM;
    }

    private static double distance(Pose view, Point edge) {
        return Math.hypot(edge.xMm() - view.xMm(), edge.yMm() - view.yMm());
    }

    private static double bearingDeg(Pose view, Point edge) {
        return Math.toDegrees(Math.atan2(edge.yMm() - view.yMm(), edge.xMm() - view.xMm()));
    }
}
