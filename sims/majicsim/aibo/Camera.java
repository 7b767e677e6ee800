package majicsim.aibo;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import javax.imageio.ImageIO;
import org.jspecify.annotations.Nullable;

/** The camera: for now one plain picture of floor and wall as JPEG, 208 by 160 (URBI sheet, sections 12 and 13). */
final class Camera {
    private static final int WIDTH = 208;
    private static final int HEIGHT = 160;

    private Value.@Nullable Binary picture;

    void install(Variables variables) {
        variables.put(new Variable("camera.val", Value.VOID, this::picture));
        variables.put(new Variable("camera.format", Value.of(1)));
        variables.put(new Variable("camera.resolution", Value.of(0)));
        variables.put(new Variable("camera.jpegfactor", Value.of(80)));
        variables.put(new Variable("camera.width", Value.of(WIDTH)));
        variables.put(new Variable("camera.height", Value.of(HEIGHT)));
        variables.put(new Variable("camera.xfov", Value.of(56.9)));
        variables.put(new Variable("camera.yfov", Value.of(44.0)));
    }

    /** The kernel repeats the last parameter of pictures it makes itself (sheet, section 12). */
    private Value picture() {
        Value.Binary taken = picture;
        if (taken == null) {
            taken = new Value.Binary(jpeg(), "jpeg " + WIDTH + " " + HEIGHT + " " + HEIGHT);
            picture = taken;
        }
        return taken;
    }

    private static String jpeg() {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D pen = image.createGraphics();
        pen.setColor(Color.LIGHT_GRAY);
        pen.fillRect(0, 0, WIDTH, HEIGHT / 2);
        pen.setColor(new Color(120, 100, 80));
        pen.fillRect(0, HEIGHT / 2, WIDTH, HEIGHT / 2);
        pen.dispose();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try {
            ImageIO.write(image, "jpeg", bytes);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot write to memory", e);
        }
        return bytes.toString(StandardCharsets.ISO_8859_1);
    }
}
