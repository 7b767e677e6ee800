package majic;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Dimension;
import java.nio.file.Path;
import java.util.Objects;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import majic.bot.MajicBot;
import majic.gui.Patience;
import majic.script.MajicParser;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Makes the pictures of the Pioneer's panel, with the robot in the middle of a curve on a stepped clock: {@code mvn
 * -Pscreenshots test}, on a machine with a display.
 */
class PioneerPictures {
    private static final Path IMAGES = Path.of("docs", "images");
    private static final int PATIENCE_S = 30;

    @Test
    @Timeout(120)
    void paintsThePioneersPanel() throws Exception {
        try (LabRig lab = LabRig.noisy(7)) {
            MajicBot bot = lab.add("pioneer");
            JFrame large = open(bot, new Dimension(900, 560), false);
            JFrame small = open(bot, new Dimension(450, 230), true);
            lab.run("1 move 2000", "1 turn 100", "1 move 1200", "1 turn 80", "1 move 1500");
            new MajicParser(lab.session(), false).parseText("1 drive 300 25 for 9s");
            double heading = bot.state().pose().headingDeg();
            lab.await(() -> bot.state().turnRateDegPerSec() > 20
                    && Math.abs(bot.state().pose().headingDeg() - heading) > 100);
            picture(large, false, "pioneer.png");
            picture(small, true, "pioneer-small.png");
        }
    }

    private static JFrame open(MajicBot bot, Dimension size, boolean dark) throws Exception {
        JFrame[] frame = new JFrame[1];
        SwingUtilities.invokeAndWait(() -> {
            look(dark);
            JComponent panel = Objects.requireNonNull(bot.display());
            panel.setPreferredSize(size);
            frame[0] = new JFrame("Pioneer");
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

    private static void picture(JFrame frame, boolean dark, String name) throws Exception {
        long start = System.nanoTime();
        Patience.await("a refresh", () -> System.nanoTime() - start > 500_000_000L, PATIENCE_S);
        SwingUtilities.invokeAndWait(() -> {
            look(dark);
            SwingUtilities.updateComponentTreeUI(frame);
            frame.getContentPane().setBackground(UIManager.getColor("Panel.background"));
        });
        WindowPicture.save(frame, IMAGES.resolve(name));
        SwingUtilities.invokeAndWait(frame::dispose);
    }
}
