package majicsim.world;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/** What may be met by the rays of one sensor at its present place. Holds until something moves. */
public final class View {
    private final Rays rays;
    private final double xMm;
    private final double yMm;
    private final @Nullable WallsInCone walls;
    private final List<Body> bodies = new ArrayList<>();

    /**
     * A view from a place.
     *
     * @param walls those that a ray may meet; null if they are looked up for each ray
     */
    View(Rays rays, Point from, @Nullable WallsInCone walls) {
        this.rays = rays;
        this.xMm = from.xMm();
        this.yMm = from.yMm();
        this.walls = walls;
    }

    /** The bodies that a ray may meet, to be filled. */
    List<Body> bodies() {
        return bodies;
    }

    /**
     * The first wall or body that a ray from this place meets.
     *
     * @param directionDeg degrees counter-clockwise from the room's x axis
     * @param maxMm length of the ray, above 0 and within the view; for the view of a cone, the direction is within it
     * @return the hit; nothing met is a hit that is not {@link Hit#found()}
     */
    public Hit ray(double directionDeg, double maxMm) {
        Ray ray = new Ray(xMm, yMm, directionDeg, maxMm);
        for (int i = 0; i < bodies.size(); i++) {
            ray.meet(bodies.get(i));
        }
        return walls == null ? rays.meetWalls(ray) : rays.meetWalls(ray, walls);
    }

    /**
     * The corners near this place, at which sound scatters: ends of walls and corners of bodies.
     *
     * @param withinMm all corners within the view that are so near are passed on, and some others
     * @param visitor receives the corners
     */
    public void cornersNear(double withinMm, Consumer<Point> visitor) {
        if (walls == null) {
            rays.room().cornersNear(xMm, yMm, withinMm, visitor);
        } else {
            endsNear(walls, withinMm, visitor);
        }
        for (int i = 0; i < bodies.size(); i++) {
            Body body = bodies.get(i);
            if (body.mayReach(xMm, yMm, withinMm)) {
                body.outline().forEach(visitor);
            }
        }
    }

    private void endsNear(WallsInCone some, double withinMm, Consumer<Point> visitor) {
        for (int i = 0; i < some.count(); i++) {
            Segment wall = rays.room().wall(some.get(i));
            if (isNear(wall.x1(), wall.y1(), withinMm)) {
                visitor.accept(new Point(wall.x1(), wall.y1()));
            }
            if (isNear(wall.x2(), wall.y2(), withinMm)) {
                visitor.accept(new Point(wall.x2(), wall.y2()));
            }
        }
    }

    private boolean isNear(double x, double y, double withinMm) {
        return Math.abs(x - xMm) <= withinMm && Math.abs(y - yMm) <= withinMm;
    }
}
