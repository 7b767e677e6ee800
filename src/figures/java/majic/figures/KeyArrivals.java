package majic.figures;

import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;

/** Measures how long F12 takes from the keyboard to the event dispatch thread. */
final class KeyArrivals implements KeyEventDispatcher {
    private final List<Double> delaysMs = new ArrayList<>();
    private long pressedNanos;

    /** Watches the keys of all windows from now on; must be called before a window is created that handles the key. */
    static KeyArrivals watch() {
        KeyArrivals arrivals = new KeyArrivals();
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(arrivals);
        return arrivals;
    }

    /** Begins to measure; must be called before the key is pressed. */
    synchronized void begin() {
        pressedNanos = System.nanoTime();
    }

    /** Returns the delay of each key so far, ms. */
    synchronized List<Double> delaysMs() {
        return List.copyOf(delaysMs);
    }

    @Override
    public synchronized boolean dispatchKeyEvent(KeyEvent event) {
        if (event.getKeyCode() == KeyEvent.VK_F12 && event.getID() == KeyEvent.KEY_PRESSED) {
            delaysMs.add((System.nanoTime() - pressedNanos) / 1e6);
        }
        return false;
    }
}
