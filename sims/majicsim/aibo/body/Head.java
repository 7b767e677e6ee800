package majicsim.aibo.body;

import java.util.Map;
import majicsim.aibo.scene.CameraPose;
import majicsim.aibo.scene.Vector;
import majicsim.world.Body;
import majicsim.world.Hit;
import majicsim.world.Point;
import majicsim.world.Pose;
import majicsim.world.World;

/**
 * The head, which carries camera and distance sensors: its pose in the room, from its joints and the body's
 * orientation.
 */
public final class Head {
    private static final double NECK_AHEAD_MM = 90;
    private static final double NECK_MM = 80;
    private static final double NOSE_MM = 60;
    private static final double LEAST_HEIGHT_MM = 20;
    private static final double FROM_A_WALL_MM = 5;

    private final World world;
    private final Body body;
    private final Map<String, Joint> joints;
    private final BodyOrientation orientation;

    public Head(World world, Body body, Map<String, Joint> joints, BodyOrientation orientation) {
        this.world = world;
        this.body = body;
        this.joints = joints;
        this.orientation = orientation;
    }

    /** From the nose, in the room. */
    public CameraPose view() {
        Pose pose = body.pose();
        ShoulderPose shoulders = orientation.shoulders();
        CameraPose view = CameraPose.from(new Vector(NOSE_MM, 0, 0))
                .pitched(degrees("headTilt"))
                .turned(degrees("headPan"))
                .moved(0, 0, NECK_MM)
                .pitched(degrees("neck") + shoulders.pitchDeg())
                .rolled(orientation.rollDeg())
                .moved(NECK_AHEAD_MM, 0, shoulders.shoulderMm())
                .turned(pose.headingDeg())
                .moved(pose.xMm(), pose.yMm(), 0);
        return view.at(inFreeAir(view.at()));
    }

    /**
     * At a wall the nose would be behind it, because only the body stops there; the nose is then placed just before the
     * wall.
     */
    private Vector inFreeAir(Vector nose) {
        Point neck = body.pose().toWorld(NECK_AHEAD_MM, 0);
        Vector way = nose.minus(new Vector(neck.xMm(), neck.yMm(), nose.z()));
        double heightMm = Math.max(LEAST_HEIGHT_MM, nose.z());
        Hit wall = world.wallRay(neck, way.azimuthDeg(), way.level() + FROM_A_WALL_MM);
        double reachMm = wall.found() ? Math.max(0, wall.distanceMm() - FROM_A_WALL_MM) : way.level();
        Vector reached = way.times(way.level() > 0 ? reachMm / way.level() : 0);
        return new Vector(neck.xMm() + reached.x(), neck.yMm() + reached.y(), heightMm);
    }

    private double degrees(String name) {
        Joint joint = joints.get(name);
        return joint == null ? 0 : joint.degrees();
    }
}
