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

    /** What rays from there may meet. */
    View view(Body viewer, Point from, double withinMm) {
        return new View(this, bodies, viewer, from, withinMm);
    }

    Hit castAtWalls(Pose from, double maxMm) {
        return meetWalls(new Ray(from, maxMm));
    }

    /** Goes along the ray cell by cell and ends with the first cell that holds the hit. */
    Hit meetWalls(Ray ray) {
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
        return ray.hit();
    }
}
