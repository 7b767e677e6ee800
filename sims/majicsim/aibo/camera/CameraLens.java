package majicsim.aibo.camera;

import java.util.List;
import majicsim.aibo.body.Head;
import majicsim.aibo.scene.CameraPose;
import majicsim.aibo.scene.Colours;
import majicsim.aibo.scene.Scene;
import majicsim.aibo.scene.Vector;
import majicsim.aibo.scene.VisibleSurface;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.World;
import org.jspecify.annotations.Nullable;

/** The lens and chip of the camera: makes a picture of the room ahead of the head. */
public final class CameraLens {
    static final double XFOV_DEG = 56.9;
    static final double YFOV_DEG = 44.0;
    private static final double TAN_X = Math.tan(Math.toRadians(XFOV_DEG / 2));
    private static final double TAN_Y = Math.tan(Math.toRadians(YFOV_DEG / 2));

    private final World world;
    private final Body body;
    private final Head head;
    private final Exposure exposure;
    private final Colours colours;
    private @Nullable Sight last;

    /**
     * What the chip receives through the lens before exposure, everything that it depends on, and the pictures of it.
     */
    private record Sight(
            CameraPose view,
            List<Pose> bodies,
            CameraSettings settings,
            int[] rgb,
            @Nullable Picture[] pictures) {
        boolean isOf(CameraPose newView, List<Pose> newBodies, CameraSettings newSettings) {
            return view.equals(newView) && bodies.equals(newBodies) && settings.equals(newSettings);
        }
    }

    public CameraLens(World world, Body body, Head head, Noise noise) {
        this.world = world;
        this.body = body;
        this.head = head;
        this.exposure = new Exposure(noise);
        this.colours = new Colours(world);
    }

    /** A picture; as long as nothing moves, one of a few with different grain. */
    Picture take(CameraSettings settings) {
        Sight sight = sight(settings);
        int pattern = exposure.drawPattern();
        Picture picture = sight.pictures()[pattern];
        if (picture == null) {
            int[] rgb = exposure.expose(sight.rgb(), settings, pattern);
            picture = new Picture(settings.width(), settings.height(), rgb);
            sight.pictures()[pattern] = picture;
        }
        return picture;
    }

    /** The room ahead; computed only if the head or a robot has moved since the last picture. */
    private Sight sight(CameraSettings settings) {
        CameraPose view = head.view();
        List<Pose> bodies = world.bodies().stream().map(Body::pose).toList();
        Sight sight = last;
        if (sight == null || !sight.isOf(view, bodies, settings)) {
            int[] rgb = colours(view, settings.width(), settings.height());
            sight = new Sight(view, bodies, settings, rgb, new Picture[Exposure.PATTERNS]);
            last = sight;
        }
        return sight;
    }

    private int[] colours(CameraPose view, int width, int height) {
        Scene scene = new Scene(world, body, view.at());
        int[] rgb = new int[width * height];
        for (int row = 0; row < height; row++) {
            double tanUp = TAN_Y * (1 - (2 * row + 1.0) / height);
            for (int column = 0; column < width; column++) {
                double tanLeft = TAN_X * (1 - (2 * column + 1.0) / width);
                rgb[row * width + column] = colour(scene, view.at(), view.ray(tanLeft, tanUp));
            }
        }
        return rgb;
    }

    private int colour(Scene scene, Vector at, Vector ray) {
        VisibleSurface surface = scene.look(ray);
        double reach = surface.levelMm() / Math.max(1e-6, ray.level());
        return colours.of(surface, at.x() + ray.x() * reach, at.y() + ray.y() * reach);
    }
}
