package majic.pictures;

import java.awt.Dimension;
import javax.swing.JFrame;
import majic.bot.MajicBot;
import majic.inlab.LabRig;
import majic.script.MajicParser;
import majicsim.LabOptions;
import majicsim.ros.options.RosOptions;
import org.junit.jupiter.api.Test;

/**
 * Makes the pictures of the panel of a ROS robot, driving on a stepped clock: {@code mvn -Pscreenshots test}, on a
 * machine with a display.
 */
class RosPictures {
    @Test
    void paintsThePanelOfARosRobot() throws Exception {
        LabOptions options = LabOptions.exactOnFreePorts()
                .withRos(RosOptions.parse("2+camera"))
                .withNoise(7);
        try (LabRig lab = LabRig.of(options)) {
            MajicBot bot = lab.add("ros");
            JFrame large = PanelPicture.open(bot, new Dimension(900, 680), false);
            JFrame small = PanelPicture.open(bot, new Dimension(450, 230), true);
            lab.run("1 move 800", "1 turn 90", "1 move 300", "1 turn 100", "1 move 600");
            MajicParser.pipe(lab.session()).parseText("1 drive 150 20 for 9s");
            lab.await(() -> bot.state().turnRateDegPerSec() > 15);
            PanelPicture.save(large, false, "ros.png");
            PanelPicture.save(small, true, "ros-small.png");
        }
    }
}
