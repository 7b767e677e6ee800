package majic.gui.command;

import java.awt.Component;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Keeps the repeats of an arrow key from a component if the key was pressed in another one and is still held, for
 * instance to drive a robot. X11 reports a held key as a sequence of releases and presses, so a release counts only if
 * no press follows soon. Must be used on the event dispatch thread.
 */
final class KeysHeldElsewhere implements KeyEventDispatcher {
    private static final long RELEASE_COUNTS_AFTER_MS = 40;
    private static final long HELD = Long.MAX_VALUE;

    private final Component target;

    /** The arrow keys pressed in other components, with the time in ms of their last release. */
    private final Map<Integer, Long> keys = new HashMap<>();

    KeysHeldElsewhere(Component target) {
        this.target = target;
    }

    void install() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(this);
    }

    void remove() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(this);
        keys.clear();
    }

    @Override
    public boolean dispatchKeyEvent(KeyEvent event) {
        if (!isArrow(event.getKeyCode())) {
            return false;
        }
        boolean pressed = event.getID() == KeyEvent.KEY_PRESSED;
        if (pressed && event.getComponent() != target) {
            keys.put(event.getKeyCode(), HELD);
        } else if (pressed) {
            return isRepeat(event, keys.remove(event.getKeyCode()));
        } else if (event.getID() == KeyEvent.KEY_RELEASED) {
            keys.replace(event.getKeyCode(), event.getWhen());
        }
        return false;
    }

    private boolean isRepeat(KeyEvent event, @Nullable Long releasedMs) {
        if (releasedMs == null || event.getWhen() - RELEASE_COUNTS_AFTER_MS > releasedMs) {
            return false;
        }
        keys.put(event.getKeyCode(), HELD);
        return true;
    }

    private static boolean isArrow(int keyCode) {
        return switch (keyCode) {
            case KeyEvent.VK_UP, KeyEvent.VK_DOWN, KeyEvent.VK_LEFT, KeyEvent.VK_RIGHT -> true;
            case KeyEvent.VK_KP_UP, KeyEvent.VK_KP_DOWN, KeyEvent.VK_KP_LEFT, KeyEvent.VK_KP_RIGHT -> true;
            default -> false;
        };
    }
}
