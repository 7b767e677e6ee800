package majicsim.world;

import java.util.ArrayList;
import java.util.List;

/** What may be met by the rays of one sensor at its present place. Holds until something moves. */
public final class View {
    private final Rays rays;
    private final double xMm;
    private final double yMm;
    private final List<Body> bodies = new ArrayList<>();

    View(Rays rays, BodyIndex index, Body viewer, Point from, double withinMm) {
        this.rays = rays;
        this.xMm = from.xMm();
        this.yMm = from.yMm();
        index.near(xMm, yMm, withinMm, body -> {
            if (body != viewer) {
                bodies.add(body);
            }
        });
    }

    /**
     * The first wall or body that a ray from this place meets.
     *
     * @param directionDeg degrees counter-clockwise from the room's x axis
     * @param maxMm length of the ray, above 0 and within the view
     * @return the hit; nothing met is a hit that is not {@link Hit#found()}
     */
    public Hit ray(double directionDeg, double maxMm) {
        Ray ray = new Ray(new Pose(xMm, yMm, directionDeg), maxMm);
        for (int i = 0; i < bodies.size(); i++) {
            ray.meet(bodies.get(i));
        }
        return rays.meetWalls(ray);
    }
}
