package majic.gui;

import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;

/**
 * Makes Esc and F12 stop all robots in every window and dialog, whatever component has the focus. The keys keep their
 * other functions, such as closing a menu: an unnecessary stop costs a click, a missed stop can cost a robot.
 */
final class StopKeys implements KeyEventDispatcher, AutoCloseable {
    private final Runnable stopAll;

    StopKeys(Runnable stopAll) {
        this.stopAll = stopAll;
    }

    void install() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(this);
    }

    @Override
    public boolean dispatchKeyEvent(KeyEvent event) {
        boolean stops = event.getKeyCode() == KeyEvent.VK_ESCAPE || event.getKeyCode() == KeyEvent.VK_F12;
        if (stops && event.getID() == KeyEvent.KEY_PRESSED) {
            stopAll.run();
        }
        return false;
    }

    @Override
    public void close() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(this);
    }
}
