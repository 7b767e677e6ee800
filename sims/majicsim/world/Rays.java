package majicsim.world;

import java.util.function.IntConsumer;

/** Finds what a ray meets first. */
final class Rays {
    /** It is cheaper to compare a ray with so many walls than to find those on its way. */
    private static final int MOST_WALLS = 24;

    private final Room room;
    private final BodyIndex bodies;

    Rays(Room room, BodyIndex bodies) {
        this.room = room;
        this.bodies = bodies;
    }

    /** What rays from there may meet. */
    View view(Body viewer, Point from, double withinMm) {
        View view = new View(this, from, null);
        bodies.near(from.xMm(), from.yMm(), withinMm, view.bodies());
        view.bodies().remove(viewer);
        return view;
    }

    /** What rays in a cone may meet. */
    View view(Body viewer, Cone cone) {
        Bounds around = cone.bounds();
        WallsInCone walls = room.wallsIn(cone, around);
        View view = new View(this, cone.tip(), walls.count() > MOST_WALLS ? null : walls);
        bodies.in(around, cone, view.bodies());
        view.bodies().remove(viewer);
        return view;
    }

    Room room() {
        return room;
    }

    Hit castAtWalls(Pose from, double maxMm) {
        return meetWalls(new Ray(from.xMm(), from.yMm(), from.headingDeg(), maxMm));
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

    /** Compares the ray with these walls only. */
    Hit meetWalls(Ray ray, WallsInCone walls) {
        for (int i = 0; i < walls.count(); i++) {
            int wall = walls.get(i);
            ray.meet(room.wallShape(wall), room.reflectivity(wall));
        }
        return ray.hit();
    }
}
