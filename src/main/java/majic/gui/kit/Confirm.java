package majic.gui.kit;

import java.awt.Window;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Asks for confirmation before an action that cannot be undone. */
public final class Confirm extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(Confirm.class);

    private Confirm(Window owner, String question, String yes, Runnable action) {
        super(owner, TEXTS.get("question"));
        JButton agree = button(yes, () -> {
            dispose();
            action.run();
        });
        fill(lines(question), agree, closing(TEXTS.get("no")));
    }

    private static JPanel lines(String text) {
        JPanel lines = new JPanel(new MigLayout("insets 0, gap 0, wrap 1"));
        text.lines().forEach(line -> lines.add(new JLabel(line)));
        return lines;
    }

    /**
     * Shows the question and returns at once.
     *
     * @param question one or more lines
     * @param yes text of the button that confirms
     * @param action runs when that button is pressed
     */
    public static void ask(Window owner, String question, String yes, Runnable action) {
        new Confirm(owner, question, yes, action).setVisible(true);
    }
}
