package majic.gui.kit;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import javax.swing.SwingUtilities;
import org.assertj.swing.edt.GuiActionRunner;

/**
 * Records the stack of the event dispatch thread when a single event keeps it for a second or more. Counts only the
 * time in which the thread computes or waits for something, so that a busy computer, on which the thread gets no
 * processor, makes no test fail.
 */
public final class EventThreadWatch {
    private static final int TICK_MS = 20;
    private static final long TICK_NANOS = TICK_MS * 1_000_000L;
    private static final long LIMIT_NANOS = 1_000_000_000L;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final List<String> stalls = new CopyOnWriteArrayList<>();
    private final Thread watching = new Thread(this::watch, "event thread watch");
    private volatile long eventThread;
    private volatile boolean answered = true;

    /** Starts to watch; must not be called on the event dispatch thread. */
    public static EventThreadWatch start() {
        EventThreadWatch watch = new EventThreadWatch();
        GuiActionRunner.execute(() -> watch.eventThread = Thread.currentThread().getId());
        watch.watching.setDaemon(true);
        watch.watching.start();
        return watch;
    }

    /** Ends watching, and fails if a stall was recorded. */
    public void checkAndEnd() {
        watching.interrupt();
        assertThat(stalls).isEmpty();
    }

    boolean hasFound() {
        return !stalls.isEmpty();
    }

    private void watch() {
        try {
            while (!Thread.currentThread().isInterrupted()) {
                ask();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Gives the thread a task, and records a stall if it does not begin it. */
    private void ask() throws InterruptedException {
        answered = false;
        SwingUtilities.invokeLater(() -> {
            eventThread = Thread.currentThread().getId();
            answered = true;
        });
        long kept = 0;
        while (!answered) {
            long before = THREADS.getThreadCpuTime(eventThread);
            Thread.sleep(TICK_MS);
            ThreadInfo thread = THREADS.getThreadInfo(eventThread, Integer.MAX_VALUE);
            if (answered || thread == null) {
                continue;
            }
            boolean reported = kept >= LIMIT_NANOS;
            kept += occupiedNanos(thread, before);
            if (!reported && kept >= LIMIT_NANOS) {
                stalls.add("the event dispatch thread was kept by " + List.of(thread.getStackTrace()));
            }
        }
        Thread.sleep(TICK_MS);
    }

    /**
     * Returns how long the thread computed, or waited for something other than the next event, in the last tick; 0 if
     * it searched components for the test.
     */
    private long occupiedNanos(ThreadInfo thread, long before) {
        boolean searching = Stream.of(thread.getStackTrace())
                .anyMatch(frame -> frame.getClassName().equals("org.assertj.swing.core.FinderDelegate"));
        if (searching) {
            return 0;
        }
        if (thread.getThreadState() == Thread.State.RUNNABLE) {
            return THREADS.getThreadCpuTime(eventThread) - before;
        }
        boolean idle = Stream.of(thread.getStackTrace())
                .anyMatch(frame -> frame.getMethodName().equals("getNextEvent"));
        return idle ? 0 : TICK_NANOS;
    }
}
