package majicsim.ros.robot;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import majicsim.world.Body;
import majicsim.world.Hit;
import majicsim.world.Noise;
import majicsim.world.Point;
import majicsim.world.Pose;
import majicsim.world.View;
import majicsim.world.World;

/**
 * The LDS-01 of a TurtleBot3: 360 beams counter-clockwise from ahead, five scans a second. It detects walls and robots.
 */
final class LaserScanner {
    static final String FRAME = "base_scan";

    /** Where it is mounted, from the turning centre. */
    static final double AHEAD_M = -0.032;

    static final double HEIGHT_M = 0.182;
    static final double SCAN_S = 0.2;

    private static final int BEAMS = 360;
    private static final double RANGE_MIN_M = 0.12;
    private static final double RANGE_MAX_M = 3.5;
    private static final double SIGMA_M = 0.01;
    private static final double MM = 1000;

    private final World world;
    private final Body body;
    private final Noise noise;
    private boolean isSpoilt;

    LaserScanner(World world, Body body, Noise noise) {
        this.world = world;
        this.body = body;
        this.noise = noise;
    }

    /** Makes two of three readings unusable in all ways that occur: NaN, both infinities and 0. A fault. */
    void spoil(boolean spoilt) {
        isSpoilt = spoilt;
    }

    ObjectNode scan(long stampNanos) {
        ObjectNode scan = Messages.stamped(stampNanos, FRAME)
                .put("angle_min", 0.0)
                .put("angle_max", Math.toRadians(BEAMS - 1))
                .put("angle_increment", Math.toRadians(1))
                .put("time_increment", SCAN_S / BEAMS)
                .put("scan_time", SCAN_S)
                .put("range_min", RANGE_MIN_M)
                .put("range_max", RANGE_MAX_M);
        Pose pose = body.pose();
        Point at = pose.toWorld(AHEAD_M * MM, 0);
        View view = world.view(body, at, RANGE_MAX_M * MM);
        ArrayNode ranges = scan.putArray("ranges");
        for (int beam = 0; beam < BEAMS; beam++) {
            ranges.add(isSpoilt && beam % 3 != 0 ? spoilt(beam) : range(view, pose.toWorldDeg(beam)));
        }
        return scan;
    }

    /** Nothing met is +infinity, nearer than the device can measure is -infinity (REP-117). */
    private double range(View view, double directionDeg) {
        Hit hit = view.ray(directionDeg, RANGE_MAX_M * MM);
        double metres = hit.distanceMm() / MM + noise.gaussian(SIGMA_M);
        if (!hit.found() || metres > RANGE_MAX_M) {
            return Double.POSITIVE_INFINITY;
        }
        return metres < RANGE_MIN_M ? Double.NEGATIVE_INFINITY : metres;
    }

    private static double spoilt(int beam) {
        return switch (beam % 4) {
            case 0 -> Double.NaN;
            case 1 -> Double.POSITIVE_INFINITY;
            case 2 -> Double.NEGATIVE_INFINITY;
            default -> 0;
        };
    }
}
