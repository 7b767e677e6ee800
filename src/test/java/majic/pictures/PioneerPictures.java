package majic.pictures;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import javax.swing.JFrame;
import majic.bot.MajicBot;
import majic.inlab.LabRig;
import majic.script.MajicParser;
import org.junit.jupiter.api.Test;

/**
 * Makes the pictures of the Pioneer's panel, with the robot in the middle of a curve on a stepped clock: {@code mvn
 * -Pscreenshots test}, on a machine with a display.
 */
class PioneerPictures {
    @Test
    void paintsThePioneersPanel() throws Exception {
        try (LabRig lab = LabRig.noisy(7)) {
            MajicBot bot = lab.add("pioneer");
            JFrame large = PanelPicture.open(bot, new Dimension(900, 560), false);
            JFrame small = PanelPicture.open(bot, new Dimension(450, 230), true);
            lab.run("1 move 2000", "1 turn 100", "1 move 1200", "1 turn 80", "1 move 1500");
            MajicParser.pipe(lab.session()).parseText("1 drive 300 25 for 9s");
            double heading = bot.state().pose().headingDeg();
            assertThat(lab.await(() -> bot.state().turnRateDegPerSec() > 20
                            && turnedDeg(heading, bot.state().pose().headingDeg()) > 100))
                    .isTrue();
            PanelPicture.save(large, false, "pioneer.png");
            PanelPicture.save(small, true, "pioneer-small.png");
        }
    }

    private static double turnedDeg(double from, double to) {
        return Math.abs(Math.IEEEremainder(to - from, 360));
    }
}
