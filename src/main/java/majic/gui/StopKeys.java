package majic.gui;

import java.awt.Component;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.util.function.BooleanSupplier;
import javax.swing.JComboBox;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;
import majic.gui.kit.MajicDialog;
import org.jspecify.annotations.Nullable;

/**
 * Makes F12 and Esc stop all robots in every window and dialog, whatever component has the focus. F12 always stops. Esc
 * does not stop while it has something to close: a menu, an open list, a dialog, or the mark of a wrong line.
 */
final class StopKeys implements KeyEventDispatcher, AutoCloseable {
    private final Runnable stopAll;
    private final BooleanSupplier lineIsMarked;

    /**
     * Creates the keys; {@link #install()} makes them work.
     *
     * @param stopAll stops all robots
     * @param lineIsMarked whether the command line has the focus and is marked as wrong
     */
    StopKeys(Runnable stopAll, BooleanSupplier lineIsMarked) {
        this.stopAll = stopAll;
        this.lineIsMarked = lineIsMarked;
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
                || lineIsMarked.getAsBoolean();
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
