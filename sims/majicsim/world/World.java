package majicsim.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A room and the bodies in it. Bodies move only in a step, and never overlap a wall or another body. Guarded by the
 * lab's lock.
 */
public final class World {
    private static final double BASE_LIGHT = 0.15;
    private static final double WHITE = 1;
    private static final double BLACK = 0.08;

    private final Room room;
    private final List<Body> bodies = new ArrayList<>();
    private final BodyIndex index;
    private final Obstacles obstacles;
    private final Motion motion;
    private final Rays rays;
    private final Lighting lighting;
    /** Which bodies move, or moved in the last step; a step does not load the memory of the others. */
    private boolean[] moving = {};

    private boolean anyTouches;

    /**
     * An empty room.
     *
     * @param room its walls
     */
    public World(Room room) {
        this.room = room;
        index = new BodyIndex(room.bounds());
        obstacles = new Obstacles(room, index);
        motion = new Motion(obstacles);
        rays = new Rays(room, index);
        lighting = new Lighting(room, rays);
    }

    /**
     * The room.
     *
     * @return as it was given
     */
    public Room room() {
        return room;
    }

    /**
     * The bodies in the order in which they were added.
     *
     * @return an unchangeable copy
     */
    public List<Body> bodies() {
        return List.copyOf(bodies);
    }

    /**
     * Puts a body into the room, at its pose.
     *
     * @param b a body of no other world
     * @throws IllegalArgumentException if it would overlap a wall or another body; it was not added
     */
    public void add(Body b) {
        if (!isFree(b, b.pose())) {
            throw new IllegalArgumentException(
                    b.name() + " does not fit at " + b.pose() + ": a wall or another body is there");
        }
        int number = bodies.size();
        moving = Arrays.copyOf(moving, number + 1);
        moving[number] = !b.wantsToRest();
        b.enter(at -> isFree(b, at), from -> index.moved(b, from), () -> moving[number] = true);
        bodies.add(b);
        index.add(b);
    }

    /**
     * Whether a body could stand at a pose.
     *
     * @param b the body; its present pose does not matter
     * @param at the pose
     * @return true if neither a wall nor another body is in its way
     */
    public boolean isFree(Body b, Pose at) {
        return obstacles.areClearOf(b, at);
    }

    /**
     * Moves every body by its commanded velocity, one after the other.
     *
     * @param seconds 0 or more; a long step is divided so that nothing jumps over a wall
     */
    public void step(double seconds) {
        boolean anyBlocked = false;
        for (int i = 0; i < moving.length; i++) {
            if (moving[i]) {
                Body body = bodies.get(i);
                motion.advance(body, seconds);
                anyBlocked |= body.blocked();
                moving[i] = !body.wantsToRest();
            }
        }
        if (anyBlocked || anyTouches) {
            detectContact(anyBlocked);
        }
    }

    private void detectContact(boolean anyBlocked) {
        anyTouches = false;
        for (Body body : bodies) {
            motion.detectContact(body, anyBlocked);
            anyTouches |= body.contact().touching();
        }
    }

    /**
     * A number that grows whenever a body moves near a place, so that what a sensor there measures can be kept
     * meanwhile.
     *
     * @param xMm place in the room
     * @param yMm place in the room
     * @param withinMm how near a part of a body must be to count; farther ones may count too
     * @return movements since the world was made
     */
    public long movementsNear(double xMm, double yMm, double withinMm) {
        return index.movementsNear(xMm, yMm, withinMm);
    }

    /**
     * The first wall or body that a ray meets.
     *
     * @param viewer the body with the sensor, which the ray passes through
     * @param xMm start of the ray in the room
     * @param yMm start of the ray in the room
     * @param directionDeg degrees counter-clockwise from the room's x axis
     * @param maxMm length of the ray, above 0
     * @return the hit; nothing met is a hit that is not {@link Hit#found()}
     */
    public Hit ray(Body viewer, double xMm, double yMm, double directionDeg, double maxMm) {
        return view(viewer, new Point(xMm, yMm), maxMm).ray(directionDeg, maxMm);
    }

    /**
     * What several rays from one place may meet, which is cheaper than to look it up for each.
     *
     * @param viewer the body with the sensor, which the rays pass through
     * @param from start of the rays in the room
     * @param withinMm length of the longest ray
     * @return the view, valid until a body moves
     */
    public View view(Body viewer, Point from, double withinMm) {
        return rays.view(viewer, from, withinMm);
    }

    /**
     * What the rays of a sensor with a cone may meet.
     *
     * @param viewer the body with the sensor, which the rays pass through
     * @param cone where the sensor looks; no ray may have a direction outside, nor be longer
     * @return the view, valid until a body moves
     */
    public View view(Body viewer, Cone cone) {
        return rays.view(viewer, cone);
    }

    /**
     * The first wall that a ray meets, as if there were no bodies.
     *
     * @param from start of the ray in the room
     * @param directionDeg degrees counter-clockwise from the room's x axis
     * @param maxMm length of the ray, above 0
     * @return the hit; nothing met is a hit that is not {@link Hit#found()}
     */
    public Hit wallRay(Point from, double directionDeg, double maxMm) {
        return rays.castAtWalls(new Pose(from.xMm(), from.yMm(), directionDeg), maxMm);
    }

    /**
     * Infra-red light at a place that does not come from a robot.
     *
     * @param xMm place in the room
     * @param yMm place in the room
     * @return 0 dark to 1 bright; 0.15 far from every lamp
     */
    public double ambientLight(double xMm, double yMm) {
        return Math.min(1, BASE_LIGHT + lighting.at(new Point(xMm, yMm)));
    }

    /**
     * The light of the lamps on a level light sensor, by its direction. Walls cast shadows.
     *
     * @param sensor its place and direction in the room
     * @return 0 without a lamp; 0.85 is bright, and close to a lamp it may be more
     */
    public double lampLight(Pose sensor) {
        return lighting.on(sensor);
    }

    /**
     * The light of the lamps on a light sensor that faces no lamp, such as one that faces the floor.
     *
     * @param place in the room
     * @return as {@link #lampLight}, but less
     */
    public double scatteredLight(Point place) {
        return lighting.scatteredAt(place);
    }

    /**
     * How well the floor reflects infra-red light.
     *
     * @param xMm place in the room
     * @param yMm place in the room
     * @return 1 for white, 0.08 over black tape, between them at its edge
     */
    public double floorReflectivity(double xMm, double yMm) {
        Point spot = new Point(xMm, yMm);
        double black = 0;
        for (Tape tape : room.tapes()) {
            black = Math.max(black, tape.coverage(spot));
        }
        return WHITE + (BLACK - WHITE) * black;
    }
}
