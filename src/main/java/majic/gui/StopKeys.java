package majic.gui;

import java.awt.Component;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import javax.swing.JComboBox;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;
import majic.gui.kit.ClosesByEsc;
import majic.gui.kit.MajicDialog;
import org.jspecify.annotations.Nullable;

/**
 * Makes F12 and Esc stop all robots in every window and dialog, whatever component has the focus. F12 always stops. Esc
 * does not stop while it has something to close: a menu, an open list, a dialog, or what a {@link ClosesByEsc} has open.
 */
final class StopKeys implements KeyEventDispatcher, AutoCloseable {
    private final Runnable stopAll;

    /**
     * Creates the keys; {@link #install()} makes them work.
     *
     * @param stopAll stops all robots
     */
    StopKeys(Runnable stopAll) {
        this.stopAll = stopAll;
    }

    void install() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(this);
    }

    /** Runs before the focused component receives the key, which is passed on in any case. */
    @Override
    public boolean dispatchKeyEvent(KeyEvent event) {
        boolean stops =
                event.getKeyCode() == KeyEvent.VK_F12 || (event.getKeyCode() == KeyEvent.VK_ESCAPE && !escCloses());
        if (event.getID() == KeyEvent.KEY_PRESSED && stops) {
            stopAll.run();
        }
        return false;
    }

    private boolean escCloses() {
        KeyboardFocusManager focus = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        return MenuSelectionManager.defaultManager().getSelectedPath().length > 0
                || isInOpenList(focus.getFocusOwner())
                || focus.getFocusedWindow() instanceof MajicDialog
                || isInOpen(focus.getFocusOwner());
    }

    private static boolean isInOpen(@Nullable Component focused) {
        for (Component component = focused; component != null; component = component.getParent()) {
            if (component instanceof ClosesByEsc closing && closing.hasToClose()) {
                return true;
            }
        }
        return false;
    }

    private static boolean isInOpenList(@Nullable Component focused) {
        Component list =
                focused instanceof JComboBox ? focused : SwingUtilities.getAncestorOfClass(JComboBox.class, focused);
        return list instanceof JComboBox<?> box && box.isPopupVisible();
    }

    @Override
    public void close() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(this);
    }
}
