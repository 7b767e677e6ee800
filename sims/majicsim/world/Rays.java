package majicsim.world;

import java.util.function.IntConsumer;

/** Finds what a ray meets first. */
final class Rays {
    private final Room room;
    private final BodyIndex bodies;

    Rays(Room room, BodyIndex bodies) {
        this.room = room;
        this.bodies = bodies;
    }

    Hit cast(Body viewer, Pose from, double maxMm) {
        Ray ray = new Ray(from, maxMm);
        bodies.near(from.xMm(), from.yMm(), maxMm, body -> {
            if (body != viewer && ray.passesNear(body.pose(), body.reachMm())) {
                ray.meet(body.shape(), Body.REFLECTIVITY);
            }
        });
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
        WallIndex index = room.index();
        double pieceMm = index.cellMm();
        IntConsumer meet = wall -> ray.meet(room.wallShape(wall), room.reflectivity(wall));
        for (double start = 0; start < ray.lengthMm(); start += pieceMm) {
            double end = Math.min(start + pieceMm, ray.lengthMm());
            index.near(
                    Math.min(ray.xAt(start), ray.xAt(end)),
                    Math.min(ray.yAt(start), ray.yAt(end)),
                    Math.max(ray.xAt(start), ray.xAt(end)),
                    Math.max(ray.yAt(start), ray.yAt(end)),
                    meet);
        }
    }
}
