package majicsim.ros.robot;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import javax.imageio.ImageIO;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import majicsim.world.Body;
import majicsim.world.Hit;
import majicsim.world.Point;
import majicsim.world.Pose;
import majicsim.world.View;
import majicsim.world.World;

/**
 * A camera that points ahead: ceiling, floor, and in each column the wall or robot that one ray meets, all of the same
 * height, darker with the distance.
 */
final class WallCamera {
    static final int WIDTH = 160;
    static final int HEIGHT = 120;

    private static final double AHEAD_MM = 60;
    private static final double WALL_MM = 300;
    private static final double HALF_ANGLE_DEG = 31;
    private static final double FARTHEST_MM = 12_000;
    private static final double PIXELS = WIDTH / 2.0 / Math.tan(Math.toRadians(HALF_ANGLE_DEG));
    private static final double HALF_BRIGHT_MM = 4000;
    private static final int CEILING = 0xC8D0D8;
    private static final int FLOOR = 0x807868;

    private final World world;
    private final Body body;

    WallCamera(World world, Body body) {
        this.world = world;
        this.body = body;
    }

    /** Takes a picture, as a JPEG file in its message. */
    ObjectNode picture(long stampNanos) {
        return Messages.stamped(stampNanos, "camera_rgb_optical_frame")
                .put("format", "jpeg")
                .put("data", jpeg(painted()));
    }

    private BufferedImage painted() {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Pose pose = body.pose();
        Point at = pose.toWorld(AHEAD_MM, 0);
        View view = world.view(body, at, FARTHEST_MM);
        for (int column = 0; column < WIDTH; column++) {
            double leftDeg = Math.toDegrees(Math.atan2(WIDTH / 2.0 - column - 0.5, PIXELS));
            Hit hit = view.ray(pose.toWorldDeg(leftDeg), FARTHEST_MM);
            paint(image, column, hit, hit.distanceMm() * Math.cos(Math.toRadians(leftDeg)));
        }
        return image;
    }

    private static void paint(BufferedImage image, int column, Hit hit, double depthMm) {
        double half = PIXELS * WALL_MM / 2 / Math.max(1, depthMm);
        int wall = hit.found() ? grey(hit.reflectivity() / (1 + depthMm / HALF_BRIGHT_MM)) : FLOOR;
        for (int row = 0; row < HEIGHT; row++) {
            double above = HEIGHT / 2.0 - row - 0.5;
            int outside = above > 0 ? CEILING : FLOOR;
            image.setRGB(column, row, Math.abs(above) <= half ? wall : outside);
        }
    }

    private static int grey(double brightness) {
        int level = (int) (255 * Math.max(0, Math.min(1, brightness)));
        return level << 16 | level << 8 | level;
    }

    private static byte[] jpeg(BufferedImage image) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(bytes)) {
            ImageIO.write(image, "jpeg", stream);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot write to memory", e);
        }
        return bytes.toByteArray();
    }
}
