package majic.gui;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.GraphicsEnvironment;
import java.awt.RenderingHints;
import java.awt.font.FontRenderContext;
import java.awt.geom.Ellipse2D;
import java.awt.image.BufferedImage;
import java.lang.System.Logger.Level;
import java.util.concurrent.atomic.AtomicBoolean;
import majic.environment.Settings;
import majic.gui.kit.EventThread;
import net.miginfocom.swing.MigLayout;

/**
 * Loads what every window needs while the program is built: the toolkit, a look and feel, the fonts, the renderer of
 * smooth shapes. Building the program takes about as long, so that the window is visible sooner
 * where there are two processors.
 */
public final class WindowPreloader {
    private static final AtomicBoolean STARTED = new AtomicBoolean();

    private WindowPreloader() {}

    /**
     * Begins to load in the background, unless there is no display or it has begun before. An error, such as a display
     * that cannot be used, is left to the window, which meets it again.
     */
    public static void start() {
        if (STARTED.compareAndSet(false, true)) {
            background("preloading the window", WindowPreloader::load);
            background("preloading the fonts", WindowPreloader::loadFonts);
        }
    }

    /** Begins to load in the background what the panels of robots need besides. */
    static void preparePanels() {
        background("preloading the panels", () -> new MigLayout("insets 0", "[grow]", "[]"));
    }

    private static void background(String name, Runnable loading) {
        EventThread.background(name, () -> {
            try {
                if (!GraphicsEnvironment.isHeadless()) {
                    loading.run();
                }
            } catch (RuntimeException | Error e) {
                System.getLogger(WindowPreloader.class.getName()).log(Level.DEBUG, name + " failed", e);
            }
        });
    }

    private static void load() {
        EventThread.later(() -> LookAndFeels.install(Settings.inMemory()));
        Graphics2D nowhere = new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB).createGraphics();
        nowhere.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        nowhere.fill(new Ellipse2D.Double(1, 1, 6, 6));
        nowhere.dispose();
    }

    private static void loadFonts() {
        FontRenderContext smooth = new FontRenderContext(null, true, true);
        new Font(Font.SANS_SERIF, Font.PLAIN, 12).getStringBounds("x", smooth);
    }
}
