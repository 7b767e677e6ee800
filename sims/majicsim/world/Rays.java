package majicsim.world;

import java.util.List;

/** Finds what a ray meets first. */
final class Rays {
    private final Room room;
    private final List<Body> bodies;

    Rays(Room room, List<Body> bodies) {
        this.room = room;
        this.bodies = bodies;
    }

    Hit cast(Body viewer, Pose from, double maxMm) {
        Ray ray = new Ray(from, maxMm);
        for (Body body : bodies) {
            if (body != viewer && from.distanceTo(body.pose()) < maxMm + body.reachMm()) {
                ray.meet(body.shapeAt(body.pose()), Body.REFLECTIVITY);
            }
        }
        meetWalls(ray);
        return ray.hit();
    }

    Hit castAtWalls(Pose from, double maxMm) {
        Ray ray = new Ray(from, maxMm);
        meetWalls(ray);
        return ray.hit();
    }

    /** Goes along the ray cell by cell and ends with the first cell that holds the hit. */
    private void meetWalls(Ray ray) {
        double pieceMm = room.index().cellMm();
        for (double start = 0; start < ray.hit().distanceMm(); start += pieceMm) {
            Point a = ray.at(start);
            Point b = ray.at(Math.min(start + pieceMm, ray.hit().distanceMm()));
            room.index()
                    .near(
                            Math.min(a.xMm(), b.xMm()),
                            Math.min(a.yMm(), b.yMm()),
                            Math.max(a.xMm(), b.xMm()),
                            Math.max(a.yMm(), b.yMm()),
                            wall -> ray.meet(
                                    room.wallShape(wall), room.walls().get(wall).reflectivity()));
        }
    }
}
