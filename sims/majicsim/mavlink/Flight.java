package majicsim.mavlink;

import majicsim.world.Body;
import majicsim.world.Pose;
import majicsim.world.World;

/**
 * How a copter moves in the air of the room: with limited acceleration to a wanted velocity, or falling. Walls and
 * robots are {@value #WALL_M} m high; above them it meets nothing, and it comes down on a wall as on the floor.
 */
final class Flight {
    /** The height of walls and robots, m. */
    static final double WALL_M = 1;

    private static final double ACCELERATION = 2.5;
    private static final double GRAVITY = 9.81;
    private static final double TURN_ACCELERATION = Math.toRadians(180);
    private static final double CRASH_SPEED = 2;
    private static final double MM = 1000;

    private final World world;
    private final Body body;
    private double height;
    private double northSpeed;
    private double eastSpeed;
    private double climb;
    private double yawRate;
    private double forwardAcceleration;
    private double rightAcceleration;
    private int crashes;

    Flight(World world, Body body) {
        this.world = world;
        this.body = body;
    }

    /** Flies for a step towards a velocity, up positive, and a turn rate, clockwise positive. */
    void fly(Velocity wanted, double seconds) {
        double most = ACCELERATION * seconds;
        double northChange = wanted.north() - northSpeed;
        double eastChange = wanted.east() - eastSpeed;
        double share = Math.min(1, most / Math.max(1e-9, Math.hypot(northChange, eastChange)));
        tilt(northChange * share / seconds, eastChange * share / seconds);
        northSpeed += northChange * share;
        eastSpeed += eastChange * share;
        climb = towards(climb, wanted.up(), most);
        yawRate = towards(yawRate, wanted.yawRate(), TURN_ACCELERATION * seconds);
        advance(seconds);
    }

    /** Falls for a step, with its motors off. */
    void fall(double seconds) {
        climb -= GRAVITY * seconds;
        advance(seconds);
    }

    /** Stays on the ground. */
    void rest() {
        northSpeed = 0;
        eastSpeed = 0;
        climb = 0;
        yawRate = 0;
        tilt(0, 0);
    }

    private void tilt(double northAcceleration, double eastAcceleration) {
        double yaw = Motion.yawOf(body.pose().headingDeg());
        forwardAcceleration = northAcceleration * Math.cos(yaw) + eastAcceleration * Math.sin(yaw);
        rightAcceleration = eastAcceleration * Math.cos(yaw) - northAcceleration * Math.sin(yaw);
    }

    private static double towards(double from, double to, double most) {
        return from + Math.max(-most, Math.min(most, to - from));
    }

    private void advance(double seconds) {
        double ground = groundBelow(height);
        height += climb * seconds;
        body.aloft(height >= WALL_M);
        Pose pose = body.pose();
        Pose next = new Pose(
                pose.xMm() + eastSpeed * MM * seconds,
                pose.yMm() + northSpeed * MM * seconds,
                pose.headingDeg() - Math.toDegrees(yawRate) * seconds);
        if (height <= ground) {
            crashes += climb < -CRASH_SPEED ? 1 : 0;
            height = ground;
            body.aloft(height >= WALL_M);
            rest();
        } else if (!body.slide(next)) {
            northSpeed = 0;
            eastSpeed = 0;
        }
    }

    /** The height of what is below a height: the floor, or from above the walls, a wall or robot. */
    private double groundBelow(double from) {
        if (from < WALL_M) {
            return 0;
        }
        boolean isAloft = body.isAloft();
        body.aloft(false);
        boolean isFree = world.isFree(body, body.pose());
        body.aloft(isAloft);
        return isFree ? 0 : WALL_M;
    }

    boolean isOnGround() {
        return climb <= 0 && height <= groundBelow(height);
    }

    double height() {
        return height;
    }

    int crashes() {
        return crashes;
    }

    Motion motion() {
        Pose pose = body.pose();
        return new Motion(
                pose.yMm() / MM,
                pose.xMm() / MM,
                height,
                northSpeed,
                eastSpeed,
                climb,
                rightAcceleration / GRAVITY,
                -forwardAcceleration / GRAVITY,
                Motion.yawOf(pose.headingDeg()),
                yawRate);
    }

    /**
     * A velocity.
     *
     * @param north m/s
     * @param east m/s
     * @param up m/s
     * @param yawRate rad/s clockwise
     */
    record Velocity(double north, double east, double up, double yawRate) {
        static final Velocity NONE = new Velocity(0, 0, 0, 0);
    }
}
