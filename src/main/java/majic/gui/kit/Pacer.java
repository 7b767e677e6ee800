package majic.gui.kit;

import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.Timer;

/** Brings a part of the window up to date after news, at most ten times a second however fast the news come. */
public final class Pacer {
    public static final int PERIOD_MS = 100;

    private final AtomicBoolean due = new AtomicBoolean();
    private final Timer timer;

    public Pacer(Runnable update) {
        timer = new Timer(PERIOD_MS, event -> {
            due.set(false);
            update.run();
        });
        timer.setRepeats(false);
    }

    /** Says that there is news; callable from any thread. */
    public void news() {
        if (due.compareAndSet(false, true)) {
            Edt.later(timer::start);
        }
    }
}
