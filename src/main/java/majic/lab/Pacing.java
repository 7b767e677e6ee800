package majic.lab;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;

/**
 * Decides when a lab's clock may take its next step. Called repeatedly on the clock's own thread. Its {@code toString}
 * describes what delays the clock.
 */
public interface Pacing {
    /**
     * Returns whether the next step may be taken; may block briefly before it returns false.
     *
     * @param nowNanos the lab's time
     * @return true to take the step now
     */
    boolean mayStep(long nowNanos);

    /**
     * Returns whether the clock must not advance while one of its members runs.
     *
     * @return true for a stepped clock
     */
    boolean awaitsMembers();

    /** Creates a pacing that steps as fast as all members keep up: once no byte is in transit on any connection. */
    static Pacing stepped(BooleanSupplier quiet) {
        return new Pacing() {
            @Override
            public boolean mayStep(long nowNanos) {
                for (int attempt = 0; attempt < 20; attempt++) {
                    if (quiet.getAsBoolean()) {
                        return true;
                    }
                    Thread.yield();
                }
                LockSupport.parkNanos(TimeUnit.MICROSECONDS.toNanos(20));
                return false;
            }

            @Override
            public boolean awaitsMembers() {
                return true;
            }

            @Override
            public String toString() {
                return "lines: " + quiet;
            }
        };
    }

    /**
     * Creates a pacing that follows the wall clock, multiplied by a speed. A lab that is late does not run faster to
     * make up for it.
     */
    static Pacing scaled(double speed) {
        return new Pacing() {
            private static final long MOST_BEHIND_NANOS = 200_000_000;

            /** Steps due within so much lab time are taken together, because each waking takes longer than a step. */
            private static final long TOGETHER_NANOS = 20_000_000;

            private long originNanos = System.nanoTime();

            @Override
            public boolean mayStep(long nowNanos) {
                long due = originNanos + (long) (nowNanos / speed);
                long ahead = due - System.nanoTime();
                if (ahead > 0) {
                    LockSupport.parkNanos(Math.max(ahead, (long) (TOGETHER_NANOS / speed)));
                    return System.nanoTime() >= due;
                }
                if (-ahead > MOST_BEHIND_NANOS) {
                    originNanos += -ahead;
                }
                return true;
            }

            @Override
            public boolean awaitsMembers() {
                return false;
            }
        };
    }
}
