package majic.pictures;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.Objects;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import majic.bot.MajicBot;
import majic.inlab.LabRig;
import majic.panel.CommandHost;
import majic.script.MajicParser;
import majicsim.LabOptions;
import majicsim.mavlink.MavlinkOptions;
import org.junit.jupiter.api.Test;

/**
 * Makes the pictures of the panel of a rover, driving on a stepped clock: {@code mvn -Pscreenshots test}, on a machine
 * with a display.
 */
class MavlinkPictures {
    @Test
    void paintsThePanelOfARover() throws Exception {
        LabOptions options = LabOptions.exactOnFreePorts()
                .withMavlink(MavlinkOptions.parse("rover+ready"))
                .withNoise(7);
        try (LabRig lab = LabRig.of(options)) {
            MajicBot bot = lab.add("mavlink");
            JFrame large = PanelPicture.open(() -> withCommands(bot), new Dimension(900, 560), false);
            JFrame small = PanelPicture.open(() -> withCommands(bot), new Dimension(450, 310), true);
            lab.run("wait 3s", "1 arm", "1 move 1200", "1 turn 90", "1 move 300", "1 turn 60");
            MajicParser.pipe(lab.session()).parseText("1 drive 200 20 for 9s");
            lab.await(() -> bot.state().turnRateDegPerSec() > 15);
            PanelPicture.save(large, false, "mavlink.png");
            PanelPicture.save(small, true, "mavlink-small.png");
        }
    }

    /** The panel as in the window, where its buttons submit commands. */
    private static JComponent withCommands(MajicBot bot) {
        JPanel host = new CommandedPanel();
        host.add(Objects.requireNonNull(bot.display()));
        return host;
    }

    private static final class CommandedPanel extends JPanel implements CommandHost {
        private static final long serialVersionUID = 1;

        CommandedPanel() {
            super(new BorderLayout());
        }

        @Override
        public void submitCommand(String command) {
            throw new AssertionError(command);
        }
    }
}
