package majic.gui;

import java.awt.AWTEvent;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.util.concurrent.atomic.AtomicIntegerArray;

/**
 * Counts the events of keys and of the mouse that arrive in the program. A display delivers them later than it takes
 * the input if its window manager is asked first, as with every click, and the window manager of a busy computer is
 * late.
 */
final class ArrivedInput implements AutoCloseable {
    private final AtomicIntegerArray arrived = new AtomicIntegerArray(AWTEvent.RESERVED_ID_MAX);
    private final AWTEventListener mouse = this::arrived;
    private final KeyEventDispatcher keys = event -> {
        arrived(event);
        return false;
    };

    private ArrivedInput() {}

    /** Starts to count, until it is closed. */
    static ArrivedInput count() {
        ArrivedInput input = new ArrivedInput();
        Toolkit.getDefaultToolkit().addAWTEventListener(input.mouse, AWTEvent.MOUSE_EVENT_MASK);
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(input.keys);
        return input;
    }

    private void arrived(AWTEvent event) {
        arrived.incrementAndGet(event.getID());
    }

    /**
     * Returns how many events have arrived so far; the last one may not have been handled yet.
     *
     * @param id that of the event, such as {@link java.awt.event.KeyEvent#KEY_PRESSED}
     */
    int count(int id) {
        return arrived.get(id);
    }

    @Override
    public void close() {
        Toolkit.getDefaultToolkit().removeAWTEventListener(mouse);
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(keys);
    }
}
