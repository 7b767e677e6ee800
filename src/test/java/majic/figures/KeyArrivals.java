package majic.figures;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;

/** Measures how long F12 takes from the keyboard to the event dispatch thread. */
final class KeyArrivals extends EventQueue {
    private final List<Double> delaysMs = new ArrayList<>();
    private long pressedNanos;

    /** Watches the events of the windows from now on. */
    static KeyArrivals watch() {
        KeyArrivals arrivals = new KeyArrivals();
        Toolkit.getDefaultToolkit().getSystemEventQueue().push(arrivals);
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
    protected void dispatchEvent(AWTEvent event) {
        if (event instanceof KeyEvent key
                && key.getKeyCode() == KeyEvent.VK_F12
                && key.getID() == KeyEvent.KEY_PRESSED) {
            arrived();
        }
        super.dispatchEvent(event);
    }

    private synchronized void arrived() {
        delaysMs.add((System.nanoTime() - pressedNanos) / 1e6);
    }
}
