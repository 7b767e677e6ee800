package majic.gui;

import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import javax.swing.MenuSelectionManager;

/**
 * Discards the character of a key that was pressed in an open menu. The menu handles the press and closes, and the
 * character would then be typed into the component that gets the focus back.
 */
final class MenuKeys implements KeyEventDispatcher {
    private boolean pressedInMenu;

    void install() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(this);
    }

    void remove() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(this);
    }

    @Override
    public boolean dispatchKeyEvent(KeyEvent event) {
        if (event.getID() == KeyEvent.KEY_PRESSED) {
            pressedInMenu = MenuSelectionManager.defaultManager().getSelectedPath().length > 0;
        }
        return event.getID() == KeyEvent.KEY_TYPED && pressedInMenu;
    }
}
