package majic.program;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Window;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import javax.swing.JFrame;
import javax.swing.RepaintManager;
import javax.swing.RootPaneContainer;
import javax.swing.SwingUtilities;

/**
 * Saves a picture of a window and the dialogs before it, painted by the components themselves: the same on every
 * display.
 */
public final class WindowPicture {
    private WindowPicture() {}

    /** Paints and saves; must be called off the event dispatch thread. */
    public static void save(JFrame frame, Path file) throws Exception {
        save(frame, file, 1);
    }

    /** Paints and saves as on a screen whose system scales windows; must be called off the event dispatch thread. */
    public static void save(JFrame frame, Path file, double scale) throws Exception {
        BufferedImage image = new BufferedImage(
                (int) Math.ceil(scale * frame.getWidth()),
                (int) Math.ceil(scale * frame.getHeight()),
                BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.scale(scale, scale);
        SwingUtilities.invokeAndWait(() -> {
            RepaintManager painting = RepaintManager.currentManager(frame);
            painting.setDoubleBufferingEnabled(false);
            paint(frame, g);
            painting.setDoubleBufferingEnabled(true);
        });
        g.dispose();
        write(image, file);
    }

    private static void paint(JFrame frame, Graphics2D g) {
        frame.getRootPane().paint(g);
        for (Window dialog : frame.getOwnedWindows()) {
            if (dialog.isShowing() && dialog instanceof RootPaneContainer content) {
                Graphics2D part = (Graphics2D) g.create(
                        dialog.getX() - frame.getX(),
                        dialog.getY() - frame.getY(),
                        dialog.getWidth(),
                        dialog.getHeight());
                content.getRootPane().paint(part);
                part.setColor(Color.GRAY);
                part.drawRect(0, 0, dialog.getWidth() - 1, dialog.getHeight() - 1);
                part.dispose();
            }
        }
    }

    private static void write(BufferedImage image, Path file) throws IOException {
        Files.createDirectories(file.toAbsolutePath().getParent());
        ImageIO.write(image, "png", file.toFile());
    }
}
