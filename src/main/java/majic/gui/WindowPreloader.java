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
import java.util.stream.Stream;
import majic.environment.Settings;
import majic.gui.bots.TeamTabs;
import majic.gui.command.CommandPane;
import majic.gui.kit.EventThread;
import majic.gui.map.TeamMap;
import majic.gui.start.StartPage;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/**
 * Loads what every window needs beside the event dispatch thread, so that the window is visible sooner where there are
 * two processors. While that thread installs a look and feel, the thread that starts the program loads the fonts and
 * builds the program. While it builds the window, another thread loads the texts and the renderer of smooth shapes. No
 * more than two threads work at the same time, since a third would take its share of the processors from the event
 * dispatch thread.
 */
public final class WindowPreloader {
    private static final AtomicBoolean STARTED = new AtomicBoolean();

    private WindowPreloader() {}

    /**
     * Begins to load a look and feel in the background and loads the fonts, unless there is no display or it was done
     * before. An error, such as a display that cannot be used, is left to the window, which meets it again.
     */
    public static void start() {
        if (STARTED.compareAndSet(false, true)) {
            background(
                    "preloading the window", () -> EventThread.later(() -> LookAndFeels.install(Settings.inMemory())));
            attempt(WindowPreloader::loadFonts);
        }
    }

    /** Begins to load in the background what a window needs while it is built and painted. */
    public static void prepareWindow() {
        background("preloading the texts", () -> {
            loadTexts();
            loadShapes();
        });
    }

    /** Begins to load in the background what the panels of robots need besides. */
    static void preparePanels() {
        background("preloading the panels", () -> new MigLayout("insets 0", "[grow]", "[]"));
    }

    private static void background(String name, Runnable loading) {
        EventThread.background(name, () -> attempt(loading));
    }

    private static void attempt(Runnable loading) {
        try {
            if (!GraphicsEnvironment.isHeadless()) {
                loading.run();
            }
        } catch (RuntimeException | Error e) {
            System.getLogger(WindowPreloader.class.getName()).log(Level.DEBUG, "preloading failed", e);
        }
    }

    /**
     * Loads the texts that the window shows at first, by one class of each package, in the order in which it is built.
     */
    private static void loadTexts() {
        Stream.of(CommandPane.class, WindowPreloader.class, StartPage.class, TeamTabs.class, TeamMap.class)
                .forEach(Texts::load);
    }

    private static void loadShapes() {
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
