package majic.gui.kit;

import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.Timer;

/** Updates a part of the window after changes, at most ten times a second however often changes occur. */
public final class UpdateThrottle {
    public static final int PERIOD_MS = 100;

    private final AtomicBoolean due = new AtomicBoolean();
    private final Timer timer;

    public UpdateThrottle(Runnable update) {
        timer = new Timer(PERIOD_MS, event -> {
            due.set(false);
            update.run();
        });
        timer.setRepeats(false);
    }

    /** Reports a change; callable from any thread. */
    public void changed() {
        if (due.compareAndSet(false, true)) {
            EventThread.later(timer::start);
        }
    }
}
