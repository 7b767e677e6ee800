package majic.gui.editor;

import java.awt.Window;
import javax.swing.JButton;
import javax.swing.JLabel;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.NamedLabel;
import majic.text.Texts;

/** Asks what to do with unsaved changes before a script is closed. */
final class UnsavedDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(UnsavedDialog.class);

    private UnsavedDialog(Window owner, String name, Runnable save, Runnable discard) {
        super(owner, TEXTS.get("unsaved"));
        JLabel question = new NamedLabel("unsaved", TEXTS.get("unsaved.question", name));
        fill(
                question,
                answer(TEXTS.get("unsaved.save"), save),
                answer(TEXTS.get("unsaved.discard"), discard),
                closing(TEXTS.get("unsaved.cancel")));
    }

    private JButton answer(String text, Runnable action) {
        return button(text, () -> {
            dispose();
            action.run();
        });
    }

    /**
     * Shows the question and returns at once.
     *
     * @param name the name of the script
     * @param save saves and closes the script
     * @param discard closes it without saving
     */
    static void ask(Window owner, String name, Runnable save, Runnable discard) {
        new UnsavedDialog(owner, name, save, discard).setVisible(true);
    }
}
