package majic.gui;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.image.BufferedImage;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import majic.environment.Settings;
import majic.gui.kit.EventThread;
import net.miginfocom.swing.MigLayout;

/**
 * Loads what every window needs while the program is built: the toolkit, a look and feel, the renderer of smooth shapes,
 * the layout manager. Building the program takes about as long, so that the window is visible sooner where there are
 * two processors.
 */
public final class WindowPreloader {
    private static final Logger LOG = System.getLogger(WindowPreloader.class.getName());

    private WindowPreloader() {}

    /**
     * Begins to load in the background. An error, such as a display that cannot be used, is left to the window, which
     * meets it again.
     */
    public static void start() {
        EventThread.background("preloading the window", () -> {
            try {
                load();
            } catch (RuntimeException | Error e) {
                LOG.log(Level.DEBUG, "the window cannot be preloaded", e);
            }
        });
    }

    private static void load() {
        EventThread.later(() -> LookAndFeels.install(Settings.inMemory()));
        Graphics2D nowhere = new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB).createGraphics();
        nowhere.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        nowhere.fill(new Ellipse2D.Double(1, 1, 6, 6));
        nowhere.dispose();
        new MigLayout("insets 0", "[grow]", "[]");
    }
}
