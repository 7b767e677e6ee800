package majic.pictures;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Dimension;
import java.nio.file.Path;
import java.util.Objects;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import majic.bot.MajicBot;
import majic.gui.WindowWait;
import majic.program.WindowPicture;

/** Makes a picture of one robot's panel, or of another component, for the documents, light or dark, of any size. */
final class PanelPicture {
    private static final Path IMAGES = Path.of("docs", "images");

    private PanelPicture() {}

    /** Shows a robot's panel in a window of its own. */
    static JFrame open(MajicBot bot, Dimension size, boolean dark) throws Exception {
        return open(() -> Objects.requireNonNull(bot.display()), size, dark);
    }

    /** Shows a component, which is made on the event thread, in a window of its own. */
    static JFrame open(Supplier<JComponent> made, Dimension size, boolean dark) throws Exception {
        JFrame[] frame = new JFrame[1];
        SwingUtilities.invokeAndWait(() -> {
            look(dark);
            JComponent panel = made.get();
            panel.setPreferredSize(size);
            frame[0] = new JFrame("panel");
            frame[0].setUndecorated(true);
            frame[0].getRootPane().setWindowDecorationStyle(0);
            frame[0].setContentPane(panel);
            frame[0].setFocusableWindowState(false);
            frame[0].pack();
            frame[0].setVisible(true);
        });
        return frame[0];
    }

    private static void look(boolean dark) {
        if (dark) {
            FlatDarkLaf.setup();
        } else {
            FlatLightLaf.setup();
        }
    }

    /** Waits until the panel shows the newest readings, paints and saves it, and closes its window. */
    static void save(JFrame frame, boolean dark, String name) throws Exception {
        long start = System.nanoTime();
        WindowWait.await("a refresh", () -> System.nanoTime() - start > 500_000_000L);
        SwingUtilities.invokeAndWait(() -> {
            look(dark);
            SwingUtilities.updateComponentTreeUI(frame);
            frame.getContentPane().setBackground(UIManager.getColor("Panel.background"));
        });
        WindowPicture.save(frame, IMAGES.resolve(name));
        SwingUtilities.invokeAndWait(frame::dispose);
    }
}
