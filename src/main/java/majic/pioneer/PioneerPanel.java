package majic.pioneer;

import java.awt.BorderLayout;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** Shows one Pioneer in the window. */
final class PioneerPanel extends JPanel {
    private static final long serialVersionUID = 1;

    private PioneerPanel(MajicPioneer bot) {
        super(new BorderLayout());
        add(new JLabel(bot.type().make()), BorderLayout.NORTH);
    }

    static JComponent create(MajicPioneer bot) {
        return new PioneerPanel(bot);
    }
}
