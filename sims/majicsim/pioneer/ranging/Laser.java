package majicsim.pioneer.ranging;

import majicsim.pioneer.model.PioneerModel;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Point;
import majicsim.world.Pose;
import majicsim.world.View;
import majicsim.world.World;

/**
 * The laser scanner that a simulated Pioneer can have on its deck, where the vendor's parameter files place it. It
 * measures walls and other robots in one plane.
 */
public final class Laser {
    /** The range if nothing was hit; the largest value used. */
    static final int FARTHEST_MM = 32_000;

    private static final double SIGMA_MM = 5;
    private static final double AHEAD_MM = 21;
    private static final double AHEAD_ON_LONG_DECKS_MM = 125;

    private final World world;
    private final Body body;
    private final Noise noise;
    private final double aheadMm;

    public Laser(World world, Body body, PioneerModel model, Noise noise) {
        this.world = world;
        this.body = body;
        this.noise = noise;
        this.aheadMm = model.subclass().startsWith("p3at") ? AHEAD_ON_LONG_DECKS_MM : AHEAD_MM;
    }

    /** All ranges in mm, in the order of the scan, at the robot's present pose. */
    public int[] ranges(LaserScan scan) {
        Pose pose = body.pose();
        Point at = pose.toWorld(aheadMm, 0);
        View view = world.view(body, at, FARTHEST_MM);
        int[] ranges = new int[scan.readings()];
        for (int i = 0; i < ranges.length; i++) {
            ranges[i] = range(view, pose.toWorldDeg(scan.directionDeg(i)));
        }
        return ranges;
    }

    private int range(View view, double directionDeg) {
        double mm = view.ray(directionDeg, FARTHEST_MM).distanceMm();
        double seen = mm >= FARTHEST_MM ? mm : mm + noise.gaussian(SIGMA_MM);
        return (int) Math.round(Math.max(0, Math.min(FARTHEST_MM, seen)));
    }
}
