package majic.gui.bots;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;

class FittedLabelTest {
    private static String shown(List<String> wordings, int width) throws Exception {
        String[] text = new String[1];
        SwingUtilities.invokeAndWait(() -> {
            FittedLabel label = new FittedLabel("label");
            label.setWordings(wordings);
            label.setBounds(0, 0, width, 20);
            text[0] = label.getText();
        });
        return text[0];
    }

    @Test
    void showsTheLongestWordingForWhichItHasRoom() throws Exception {
        List<String> wordings = List.of("stop not confirmed", "unconfirmed", "");

        assertThat(shown(wordings, 400)).isEqualTo("stop not confirmed");
        assertThat(shown(wordings, 100)).isEqualTo("unconfirmed");
        assertThat(shown(wordings, 30)).isEmpty();
    }

    @Test
    void shortensTheLastWordingAlone() throws Exception {
        assertThat(shown(List.of("Wanderer (Pioneer)", "Wanderer"), 10)).isEqualTo("Wanderer");
    }
}
