package majic.gui.kit;

import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;

/**
 * A dialog with its content above a row of buttons. Never modal, so that STOP, messages and map stay within reach.
 */
public class MajicDialog extends JDialog {
    private static final long serialVersionUID = 1L;

    public MajicDialog(Window owner, String title) {
        super(owner, title, ModalityType.MODELESS);
        setName(title + " dialog");
        setDefaultCloseOperation(DISPOSE_ON_CLOSE);
        addWindowListener(new WindowAdapter() {
            /** A window manager may give the keys to another window when a dialog before this one has just closed. */
            @Override
            public void windowOpened(WindowEvent event) {
                toFront();
                requestFocus();
            }
        });
    }

    /** Places everything; the first button is the one that Enter presses. */
    public final void fill(JComponent content, JButton... buttons) {
        JPanel all = new JPanel(new MigLayout("insets 14, gap 8 12", "[grow, fill]", "[grow, fill][]"));
        all.add(content, "wrap");
        JPanel row = new JPanel(new MigLayout("insets 0, gap 8, alignx right"));
        for (JButton button : buttons) {
            row.add(button, "sizegroup b, wmin 80");
        }
        all.add(row);
        setContentPane(all);
        getRootPane().setDefaultButton(buttons[0]);
        pack();
        setMinimumSize(getSize());
        setLocationRelativeTo(getOwner());
    }

    /** A button that does something. */
    public static JButton button(String text, Runnable action) {
        JButton button = new JButton(text);
        button.setName(text);
        button.addActionListener(event -> action.run());
        return button;
    }

    /** A button that closes this dialog. */
    public final JButton closing(String text) {
        return button(text, this::dispose);
    }
}
