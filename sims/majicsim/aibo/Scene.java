package majicsim.aibo;

import majicsim.world.Body;
import majicsim.world.World;
import org.jspecify.annotations.Nullable;

/** What is around an eye for the time of one picture; slices of the room are cut when they are first looked at, and kept. */
final class Scene {
    private static final double SLICE_DEG = 0.125;
    private static final int SLICES = (int) (360 / SLICE_DEG);

    private final World world;
    private final Body viewer;
    private final Vector eye;
    private final @Nullable Slice[] slices = new Slice[SLICES];

    Scene(World world, Body viewer, Vector eye) {
        this.world = world;
        this.viewer = viewer;
        this.eye = eye;
    }

    /** What lies in a direction. */
    Sight look(Vector ray) {
        int number = Math.floorMod((int) Math.rint(ray.azimuthDeg() / SLICE_DEG), SLICES);
        Slice slice = slices[number];
        if (slice == null) {
            slice = new Slice(world, viewer, eye, number * SLICE_DEG);
            slices[number] = slice;
        }
        return slice.look(slope(ray));
    }

    /** How far it is in a direction to the first surface, in mm through the air. */
    static double distanceMm(World world, Body viewer, View view) {
        double slope = slope(view.ahead());
        Sight sight = new Slice(world, viewer, view.at(), view.ahead().azimuthDeg()).look(slope);
        return sight.levelMm() * Math.sqrt(1 + slope * slope);
    }

    private static double slope(Vector ray) {
        return ray.z() / Math.max(1e-6, ray.level());
    }
}
