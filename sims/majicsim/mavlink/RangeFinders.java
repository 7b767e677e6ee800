package majicsim.mavlink;

import majicsim.world.Body;
import majicsim.world.Hit;
import majicsim.world.Noise;
import majicsim.world.Point;
import majicsim.world.Pose;
import majicsim.world.View;
import majicsim.world.World;

/**
 * Range finders at the four sides of the hull, and a scanner on top that looks all around from the middle. Distances
 * are in cm. Above the walls they detect nothing.
 */
final class RangeFinders {
    static final int LEAST_CM = 20;
    static final int MOST_CM = 800;
    static final int BEAMS = 72;
    static final int DEGREES_A_BEAM = 5;

    private static final double CM = 10;
    private static final double SIGMA_MM = 10;

    private final World world;
    private final Body body;
    private final Noise noise;
    private final double halfLengthMm;
    private final double halfWidthMm;

    RangeFinders(World world, Body body, Noise noise, Point corner) {
        this.world = world;
        this.body = body;
        this.noise = noise;
        this.halfLengthMm = corner.xMm();
        this.halfWidthMm = corner.yMm();
    }

    /** The distance from the hull to what is there, by degrees clockwise from ahead: 0, 90, 180 or 270. */
    int fromHull(int clockwiseDeg) {
        double hullMm = clockwiseDeg % 180 == 0 ? halfLengthMm : halfWidthMm;
        double fromMiddle = millimetres(view(), clockwiseDeg, hullMm + MOST_CM * CM);
        return centimetres(fromMiddle - hullMm);
    }

    /** The distances from the middle, clockwise from ahead; {@link #MOST_CM} + 1 where nothing is in reach. */
    int[] around() {
        View view = view();
        int[] distances = new int[BEAMS];
        for (int beam = 0; beam < BEAMS; beam++) {
            distances[beam] = centimetres(millimetres(view, beam * DEGREES_A_BEAM, (MOST_CM + 1) * CM));
        }
        return distances;
    }

    private View view() {
        Pose pose = body.pose();
        return world.view(body, new Point(pose.xMm(), pose.yMm()), (MOST_CM + 1) * CM + halfLengthMm);
    }

    private double millimetres(View view, int clockwiseDeg, double mostMm) {
        if (body.isAloft()) {
            return Double.POSITIVE_INFINITY;
        }
        Hit hit = view.ray(body.pose().toWorldDeg(-clockwiseDeg), mostMm);
        return hit.found() ? hit.distanceMm() + noise.gaussian(SIGMA_MM) : Double.POSITIVE_INFINITY;
    }

    private static int centimetres(double mm) {
        return (int) Math.max(0, Math.min(MOST_CM + 1, Math.round(mm / CM)));
    }
}
