package majic.aibo;

import javax.swing.JComponent;
import javax.swing.JPanel;

/** Shows the dog. */
final class AiboPanel extends JPanel {
    private static final long serialVersionUID = 1;

    private AiboPanel() {}

    static JComponent create(MajicAibo bot) {
        return new AiboPanel();
    }
}
