package majicsim.world;

import java.util.List;

/** What is in a body's way: the walls near it and the other bodies. */
final class Obstacles {
    /** Walls farther than this are not looked at one by one. */
    private static final double LOOK_MM = 300;

    private static final Gap FAR = new Gap(LOOK_MM, new Point(0, 0));

    private final Room room;
    private final List<Body> bodies;

    Obstacles(Room room, List<Body> bodies) {
        this.room = room;
        this.bodies = bodies;
    }

    /** Whether the body could stand there. */
    boolean areClearOf(Body body, Pose at) {
        Shape shape = body.shapeAt(at);
        return wallGap(body, shape, at, 1).mm() > 0
                && bodyGap(body, shape, at, 1).mm() > 0;
    }

    /**
     * As {@link #areClearOf}, for a motion of at most so many mm from where the body stands; walls are measured only when the
     * room known to be free around it is used up.
     */
    boolean areClearOf(Body body, Pose at, double travelMm) {
        if (travelMm >= body.wallFreeMm()) {
            body.wallFreeMm(wallGap(body, body.shapeAt(body.pose()), body.pose(), LOOK_MM)
                    .mm());
        }
        Shape shape = body.shapeAt(at);
        boolean wallsClear =
                travelMm < body.wallFreeMm() || wallGap(body, shape, at, 1).mm() > 0;
        return wallsClear && bodyGap(body, shape, at, 1).mm() > 0;
    }

    /** The nearest thing as the body stands, if it is within so many mm; otherwise something far. */
    Gap nearest(Body body, double withinMm) {
        Shape shape = body.shapeAt(body.pose());
        Gap wall = wallGap(body, shape, body.pose(), withinMm);
        Gap other = bodyGap(body, shape, body.pose(), withinMm);
        return wall.mm() < other.mm() ? wall : other;
    }

    private Gap wallGap(Body body, Shape shape, Pose at, double withinMm) {
        double look = body.reachMm() + withinMm;
        Gap[] best = {FAR};
        room.index().near(at.xMm() - look, at.yMm() - look, at.xMm() + look, at.yMm() + look, wall -> {
            Gap gap = Gap.between(shape, room.wallShape(wall));
            if (gap.mm() < best[0].mm()) {
                best[0] = gap;
            }
        });
        return best[0];
    }

    private Gap bodyGap(Body body, Shape shape, Pose at, double withinMm) {
        Gap best = FAR;
        for (Body other : bodies) {
            double far = body.reachMm() + other.reachMm() + withinMm;
            if (other != body && at.distanceTo(other.pose()) < far) {
                Gap gap = Gap.between(shape, other.shapeAt(other.pose()));
                best = gap.mm() < best.mm() ? gap : best;
            }
        }
        return best;
    }
}
