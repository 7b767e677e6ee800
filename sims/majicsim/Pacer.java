package majicsim;

import java.util.concurrent.locks.LockSupport;

/** Steps a lab at a multiple of real time, on a daemon thread. If the computer is too slow, lab time falls behind and is not made up. */
final class Pacer {
    private static final long MOST_LAG_NANOS = 100_000_000;
    private static final int JOIN_MS = 1000;

    private final Lab lab;
    private final double speed;
    private final Thread thread = new Thread(this::run, "lab-clock");
    private volatile boolean running = true;

    Pacer(Lab lab, double speed) {
        this.lab = lab;
        this.speed = speed;
        thread.setDaemon(true);
    }

    void start() {
        thread.start();
    }

    void end() {
        running = false;
        LockSupport.unpark(thread);
        try {
            thread.join(JOIN_MS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void run() {
        long stepNanos = Math.max(1, (long) (Lab.STEP_NANOS / speed));
        long due = System.nanoTime() + stepNanos;
        while (running) {
            long early = due - System.nanoTime();
            if (early > 0) {
                LockSupport.parkNanos(early);
                continue;
            }
            lab.step();
            due = Math.max(due + stepNanos, System.nanoTime() - MOST_LAG_NANOS);
        }
    }
}
