package majic.gui.command;

import java.awt.Component;
import java.awt.KeyEventPostProcessor;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import javax.swing.JComboBox;
import javax.swing.JList;
import javax.swing.JTable;
import javax.swing.JTree;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.jspecify.annotations.Nullable;

/**
 * Passes letters and digits that are typed on another component of the window to a text field, and gives it the focus.
 * A key that the component uses stays there, and so does everything typed into an editable text, a list or a table. Must
 * be used on the event dispatch thread.
 */
final class TypingToLine implements KeyEventPostProcessor {
    private final JTextComponent field;
    private boolean pressUsed;

    TypingToLine(JTextComponent field) {
        this.field = field;
    }

    void install() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventPostProcessor(this);
    }

    void remove() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventPostProcessor(this);
    }

    /** Runs after the focused component and the key bindings of its window have had the key. */
    @Override
    public boolean postProcessKeyEvent(KeyEvent event) {
        if (event.getID() == KeyEvent.KEY_PRESSED) {
            pressUsed = event.isConsumed();
        } else if (event.getID() == KeyEvent.KEY_TYPED && !pressUsed && !event.isConsumed() && isForField(event)) {
            event.consume();
            field.requestFocusInWindow();
            field.setCaretPosition(field.getDocument().getLength());
            field.replaceSelection(String.valueOf(event.getKeyChar()));
            return true;
        }
        return false;
    }

    private boolean isForField(KeyEvent event) {
        boolean plain = !event.isControlDown() && !event.isAltDown() && !event.isMetaDown();
        Component focused = event.getComponent();
        return plain
                && Character.isLetterOrDigit(event.getKeyChar())
                && focused != field
                && SwingUtilities.getWindowAncestor(focused) == SwingUtilities.getWindowAncestor(field)
                && !takesText(focused)
                && MenuSelectionManager.defaultManager().getSelectedPath().length == 0;
    }

    private static boolean takesText(@Nullable Component focused) {
        return (focused instanceof JTextComponent text && text.isEditable())
                || focused instanceof JList
                || focused instanceof JTable
                || focused instanceof JTree
                || focused instanceof JComboBox;
    }
}
