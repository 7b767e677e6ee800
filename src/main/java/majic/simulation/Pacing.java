package majic.simulation;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;

/**
 * When a lab's clock may take its next step. Asked on the clock's own thread, again and again. In words it says what holds
 * the clock.
 */
public interface Pacing {
    /**
     * Whether the next step may be taken; may wait a little before it says no.
     *
     * @param nowNanos the lab's time
     * @return true to take the step now
     */
    boolean mayStep(long nowNanos);

    /**
     * Whether the clock stands still while somebody who lives by it is running.
     *
     * @return true for a stepped clock
     */
    boolean awaitsMembers();

    /** Steps as fast as everybody keeps up: once nothing is under way on any line. */
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

    /** Follows the wall clock, so many times as fast. A lab that falls behind does not race to catch up. */
    static Pacing scaled(double speed) {
        return new Pacing() {
            private static final long MOST_BEHIND_NANOS = 200_000_000;
            private long originNanos = System.nanoTime();

            @Override
            public boolean mayStep(long nowNanos) {
                long due = originNanos + (long) (nowNanos / speed);
                long ahead = due - System.nanoTime();
                if (ahead > 0) {
                    LockSupport.parkNanos(ahead);
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
