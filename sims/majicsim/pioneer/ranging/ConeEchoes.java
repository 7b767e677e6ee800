package majicsim.pioneer.ranging;

import java.util.function.Consumer;
import majicsim.world.Body;
import majicsim.world.Cone;
import majicsim.world.Hit;
import majicsim.world.Point;
import majicsim.world.Pose;
import majicsim.world.View;
import majicsim.world.World;

/**
 * What there is in the cone of one disc to throw sound back: the surfaces that a few rays meet, and the nearest corner
 * in sight. It holds until something near moves.
 */
final class ConeEchoes implements Consumer<Point> {
    private static final double HALF_CONE_DEG = 15;
    private static final double BETWEEN_RAYS_DEG = 5;
    private static final int RAYS = 1 + (int) (2 * HALF_CONE_DEG / BETWEEN_RAYS_DEG);
    private static final double EDGE_ECHO_MM = 2500;
    /** How much nearer something may be hit on the way to an edge that still counts as in sight. */
    private static final double EDGE_SLACK_MM = 2;

    private final Pose axis;
    private final View view;
    private final double[] surfaceMm = new double[RAYS];
    private final double[] squareness = new double[RAYS];
    private double edgeMm;

    /** Looks from a disc's place in its direction, as far as this. */
    ConeEchoes(World world, Body body, Pose axis, double farthestMm) {
        this.axis = axis;
        view = world.view(body, new Cone(axis, HALF_CONE_DEG, farthestMm));
        edgeMm = farthestMm;
        for (int i = 0; i < RAYS; i++) {
            double direction = axis.headingDeg() - HALF_CONE_DEG + i * BETWEEN_RAYS_DEG;
            Hit hit = view.ray(direction, farthestMm);
            surfaceMm[i] = hit.distanceMm();
            squareness[i] = hit.squareness();
        }
        view.cornersNear(EDGE_ECHO_MM, this);
    }

    /** The distance of the nearest echo, if surfaces send one back up to this angle from perpendicular, 0 to 180. */
    double nearestMm(double echoWithinDeg) {
        double least = Math.cos(Math.toRadians(echoWithinDeg));
        double nearest = edgeMm;
        for (int i = 0; i < RAYS; i++) {
            if (squareness[i] >= least) {
                nearest = Math.min(nearest, surfaceMm[i]);
            }
        }
        return nearest;
    }

    /** Records an edge, if it is in sight and the nearest so far. */
    @Override
    public void accept(Point edge) {
        double dx = edge.xMm() - axis.xMm();
        double dy = edge.yMm() - axis.yMm();
        double square = dx * dx + dy * dy;
        if (square > 0 && square < EDGE_ECHO_MM * EDGE_ECHO_MM && square < edgeMm * edgeMm) {
            double bearing = Math.toDegrees(Math.atan2(dy, dx));
            double distance = Math.sqrt(square);
            if (isInCone(bearing) && isInSight(bearing, distance)) {
                edgeMm = distance;
            }
        }
    }

    private boolean isInCone(double bearingDeg) {
        return Math.abs(Pose.normalised(bearingDeg - axis.headingDeg())) <= HALF_CONE_DEG;
    }

    private boolean isInSight(double bearingDeg, double distanceMm) {
        Hit hit = view.ray(bearingDeg, distanceMm);
        return !hit.found() || hit.distanceMm() > distanceMm - EDGE_SLACK_MM;
    }
}
