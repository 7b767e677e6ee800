package majic.pictures;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import javax.swing.JFrame;
import majic.bot.MajicBot;
import majic.inlab.LabRig;
import majic.script.MajicParser;
import org.junit.jupiter.api.Test;

/**
 * Makes the pictures of the Aibo's panel, with the dog in the middle of a walk on a stepped clock: {@code mvn
 * -Pscreenshots test}, on a machine with a display.
 */
class AiboPictures {
    @Test
    void paintsTheAibosPanel() throws Exception {
        try (LabRig lab = LabRig.noisy(7)) {
            MajicBot bot = lab.add("aibo");
            JFrame large = PanelPicture.open(bot, new Dimension(900, 560), false);
            JFrame small = PanelPicture.open(bot, new Dimension(515, 270), true);
            lab.run("1 set ledBFC 1", "1 set ledBRW 0.7", "1 set modeG on", "1 set ledHC on");
            for (int led = 1; led <= 14; led += 3) {
                lab.run("1 set ledF" + led + " " + led / 14.0);
            }
            lab.run("1 move 600", "1 set headPan 25", "1 set headTilt 10", "1 set mouth -30", "1 set tail 20 40");
            MajicParser.pipe(lab.session()).parseText("1 move 900");
            assertThat(lab.await(() -> bot.state().pose().xMm() > 900)).isTrue();
            PanelPicture.save(large, false, "aibo.png");
            PanelPicture.save(small, true, "aibo-small.png");
        }
    }
}
