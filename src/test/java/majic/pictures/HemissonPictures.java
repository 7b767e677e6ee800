package majic.pictures;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.util.List;
import javax.swing.JFrame;
import majic.bot.MajicBot;
import majic.bot.Value;
import majic.bot.Value.Flag.Words;
import majic.inlab.LabRig;
import majic.script.MajicParser;
import org.junit.jupiter.api.Test;

/**
 * Makes the pictures of the Hemisson's panel, with the robot moving along a wall on a stepped clock: {@code mvn
 * -Pscreenshots test}, on a machine with a display.
 */
class HemissonPictures {
    private static final Value ON = new Value.Flag(true, Words.ON_OFF);

    @Test
    void paintsTheHemissonsPanel() throws Exception {
        try (LabRig lab = LabRig.noisy(7)) {
            MajicBot bot = lab.add("hemisson");
            JFrame large = PanelPicture.open(bot, new Dimension(900, 560), false);
            JFrame small = PanelPicture.open(bot, new Dimension(450, 230), true);
            lab.run(
                    "1 move 300",
                    "1 turn 100",
                    "1 move 200",
                    "1 turn -60",
                    "1 move 3000 until distanceFront < 40",
                    "1 move 3000 until distanceFront < 18");
            bot.set("ledLeft", List.of(ON));
            bot.set("beep", List.of(ON));
            lab.team().time().sleep(2);
            MajicParser.pipe(lab.session()).parseText("1 drive 20 40 for 3s");
            assertThat(lab.await(() -> bot.state().turnRateDegPerSec() > 20)).isTrue();
            PanelPicture.save(large, false, "hemisson.png");
            PanelPicture.save(small, true, "hemisson-small.png");
        }
    }
}
