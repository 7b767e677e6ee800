package majic.gui.command;

import java.awt.Component;
import java.awt.KeyEventDispatcher;
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
 * What is typed until it has the focus, spaces too, goes to the field. A key that the component uses stays there, and
 * so does everything typed into an editable text, a list or a table. Must be used on the event dispatch thread.
 */
final class TypingToLine implements KeyEventPostProcessor, KeyEventDispatcher {
    private final JTextComponent field;
    private @Nullable Component leaving;
    private boolean pressUsed;

    TypingToLine(JTextComponent field) {
        this.field = field;
    }

    void install() {
        KeyboardFocusManager keys = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        keys.addKeyEventDispatcher(this);
        keys.addKeyEventPostProcessor(this);
    }

    void remove() {
        KeyboardFocusManager keys = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        keys.removeKeyEventDispatcher(this);
        keys.removeKeyEventPostProcessor(this);
    }

    /** Runs before the focused component has the key; the component that is losing the focus gets no character. */
    @Override
    public boolean dispatchKeyEvent(KeyEvent event) {
        if (leaving == null) {
            return false;
        }
        if (!isUnderway(event.getComponent())) {
            leaving = null;
            return false;
        }
        char typed = event.getKeyChar();
        if (typed == KeyEvent.CHAR_UNDEFINED
                || Character.isISOControl(typed)
                || event.getID() == KeyEvent.KEY_RELEASED) {
            return false;
        }
        KeyboardFocusManager.getCurrentKeyboardFocusManager().redispatchEvent(field, event);
        return true;
    }

    /** The window itself has the keys after one component has lost the focus and before the next one gets it. */
    private boolean isUnderway(Component target) {
        return target == leaving || target == SwingUtilities.getWindowAncestor(field);
    }

    /** Runs after the focused component and the key bindings of its window have had the key. */
    @Override
    public boolean postProcessKeyEvent(KeyEvent event) {
        if (event.getID() == KeyEvent.KEY_PRESSED) {
            pressUsed = event.isConsumed();
        } else if (event.getID() == KeyEvent.KEY_TYPED && !pressUsed && !event.isConsumed() && isForField(event)) {
            event.consume();
            leaving = field.requestFocusInWindow() ? event.getComponent() : null;
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
