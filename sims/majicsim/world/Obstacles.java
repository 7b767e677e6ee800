package majicsim.world;

import java.util.ArrayList;
import java.util.List;

/** What is in a body's way: the walls near it and the other bodies. */
final class Obstacles {
    /** Walls farther than this are not looked at one by one. */
    private static final double LOOK_MM = 300;

    private static final Gap FAR = new Gap(LOOK_MM, new Point(0, 0));

    private final Room room;
    private final BodyIndex bodies;
    private final List<Body> found = new ArrayList<>();

    Obstacles(Room room, BodyIndex bodies) {
        this.room = room;
        this.bodies = bodies;
    }

    /** Whether the body could be there. */
    boolean areClearOf(Body body, Pose at) {
        return body.isAloft() || areWallsClearOf(body, at) && areBodiesClearOf(body, at);
    }

    /** Whether the body could stand there if it were alone. */
    boolean areWallsClearOf(Body body, Pose at) {
        return wallGap(body, body.shapeAt(at), at, 1).mm() > 0;
    }

    /**
     * As {@link #areClearOf(Body, Pose)}, for a motion of at most so many mm from where the body stands; walls are
     * measured only when the room known to be free around it is used up.
     */
    boolean areClearOf(Body body, Pose at, double travelMm) {
        if (travelMm >= body.wallFreeMm() && !body.isMeasured()) {
            body.measured(wallGap(body, body.shapeAt(body.pose()), body.pose(), LOOK_MM)
                    .mm());
        }
        return (travelMm < body.wallFreeMm() || areWallsClearOf(body, at)) && areBodiesClearOf(body, at);
    }

    /** The nearest thing as the body stands, if it is within so many mm; otherwise something far. */
    Gap nearest(Body body, double withinMm) {
        Shape shape = body.shapeAt(body.pose());
        Gap wall = wallGap(body, shape, body.pose(), withinMm);
        Gap other = bodyGap(body, shape, body.pose(), withinMm);
        return Gap.nearer(wall, other);
    }

    private boolean areBodiesClearOf(Body body, Pose at) {
        List<Body> others = bodiesNear(at, body.reachMm());
        for (int i = 0; i < others.size(); i++) {
            Body other = others.get(i);
            if (isNear(body, other, at, 1)
                    && Gap.between(body.shapeAt(at), other.shape()).mm() <= 0) {
                return false;
            }
        }
        return true;
    }

    private Gap wallGap(Body body, Shape shape, Pose at, double withinMm) {
        double look = body.reachMm() + withinMm;
        Gap[] best = {FAR};
        room.index().near(at.xMm() - look, at.yMm() - look, at.xMm() + look, at.yMm() + look, wall -> {
            Shape other = room.wallShape(wall);
            if (other.edgeDistanceMm(at.xMm(), at.yMm()) < look) {
                best[0] = Gap.nearer(best[0], Gap.between(shape, other));
            }
        });
        return best[0];
    }

    private Gap bodyGap(Body body, Shape shape, Pose at, double withinMm) {
        Gap best = FAR;
        for (Body other : bodiesNear(at, body.reachMm() + withinMm)) {
            if (isNear(body, other, at, withinMm)) {
                best = Gap.nearer(best, Gap.between(shape, other.shape()));
            }
        }
        return best;
    }

    /** The same list at each call, because this is called for each step of each moving body. */
    private List<Body> bodiesNear(Pose at, double withinMm) {
        found.clear();
        bodies.near(at.xMm(), at.yMm(), withinMm, found);
        return found;
    }

    private static boolean isNear(Body body, Body other, Pose at, double withinMm) {
        return other != body && at.distanceTo(other.pose()) < body.reachMm() + other.reachMm() + withinMm;
    }
}
