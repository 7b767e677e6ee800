package majicsim.aibo.scene;

import majicsim.world.Body;
import majicsim.world.World;
import org.jspecify.annotations.Nullable;

/** The room around the camera for one picture. Slices of the room are computed at their first use, and kept. */
public final class Scene {
    private static final double SLICE_DEG = 0.125;
    private static final int SLICES = (int) (360 / SLICE_DEG);

    private final World world;
    private final Body viewer;
    private final Vector eye;
    private final @Nullable RoomSlice[] slices = new RoomSlice[SLICES];

    public Scene(World world, Body viewer, Vector eye) {
        this.world = world;
        this.viewer = viewer;
        this.eye = eye;
    }

    /** The surface in a direction. */
    public VisibleSurface look(Vector ray) {
        int number = Math.floorMod((int) Math.rint(ray.azimuthDeg() / SLICE_DEG), SLICES);
        RoomSlice slice = slices[number];
        if (slice == null) {
            slice = new RoomSlice(world, viewer, eye, number * SLICE_DEG);
            slices[number] = slice;
        }
        return slice.look(slope(ray));
    }

    /** The distance in a direction to the first surface, in mm. */
    public static double distanceMm(World world, Body viewer, CameraPose view) {
        double slope = slope(view.ahead());
        VisibleSurface surface =
                new RoomSlice(world, viewer, view.at(), view.ahead().azimuthDeg()).look(slope);
        return surface.levelMm() * Math.sqrt(1 + slope * slope);
    }

    private static double slope(Vector ray) {
        return ray.z() / Math.max(1e-6, ray.level());
    }
}
