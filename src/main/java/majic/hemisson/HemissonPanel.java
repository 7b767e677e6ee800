package majic.hemisson;

import javax.swing.JComponent;
import javax.swing.JPanel;

/** Shows a Hemisson: its readings where its sensors sit. */
final class HemissonPanel extends JPanel {
    private static final long serialVersionUID = 1;

    private HemissonPanel() {}

    static JComponent create(MajicHemisson bot) {
        return new HemissonPanel();
    }
}
