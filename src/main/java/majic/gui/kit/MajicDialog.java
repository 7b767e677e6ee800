package majic.gui.kit;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import majic.panel.KeyAction;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;

/**
 * A dialog with its content above a row of buttons. Never modal, so that STOP, messages and map stay accessible. Esc
 * and Ctrl W close it, as its Cancel or Close does.
 */
public class MajicDialog extends JDialog {
    private static final long serialVersionUID = 1L;

    private transient @Nullable Component first;
    private @Nullable Dimension least;

    public MajicDialog(Window owner, String title) {
        super(owner, title, ModalityType.MODELESS);
        setName(title + " dialog");
        setDefaultCloseOperation(DISPOSE_ON_CLOSE);
        KeyAction.bind(
                getRootPane(), JComponent.WHEN_IN_FOCUSED_WINDOW, KeyStroke.getKeyStroke("ESCAPE"), event -> dispose());
        CloseKey.install(this);
        addWindowListener(new WindowAdapter() {
            /**
             * Requests the focus, because a window manager may give it to another window when a previous dialog has
             * just closed. A component gets it: if the dialog itself had it, what is typed would be lost.
             */
            @Override
            public void windowOpened(WindowEvent event) {
                toFront();
                first().requestFocus();
            }
        });
    }

    private Component first() {
        Component chosen = first == null ? getFocusTraversalPolicy().getInitialComponent(this) : first;
        return chosen == null ? this : chosen;
    }

    /** Sets the component that gets the focus when the dialog opens, in place of the first one that can have it. */
    protected final void focusFirst(Component component) {
        first = component;
    }

    /** Sets the least size of a dialog whose content scrolls, in place of its usual size; used by {@link #fill}. */
    protected final void canShrinkTo(int width, int height) {
        least = UIScale.scale(new Dimension(width, height));
    }

    /**
     * Adds content and buttons; the first button is the default one, which Enter presses. The dialog gets its usual
     * size, as far as the screen has room for it, and a place where STOP stays visible if there is one.
     */
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
        Mnemonics.assign(all);
        pack();
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        setSize(Math.min(getWidth(), screen.width), Math.min(getHeight(), screen.height));
        setMinimumSize(least == null ? getSize() : least);
        setLocationRelativeTo(getOwner());
        ClearOfStop.place(this, getOwner());
    }

    /** Creates the label of a field; the field gets its accessible name from it. */
    public static JLabel label(String text, JComponent field) {
        JLabel label = new JLabel(text);
        label.setLabelFor(field);
        return label;
    }

    /** Creates a button that runs an action. */
    public static JButton button(String text, Runnable action) {
        JButton button = new JButton(text);
        button.setName(text);
        button.addActionListener(event -> action.run());
        return button;
    }

    /** Creates a button that closes this dialog. */
    public final JButton closing(String text) {
        return button(text, this::dispose);
    }
}
