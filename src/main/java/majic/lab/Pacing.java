package majic.lab;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * Decides when a lab's clock may take its next step. Called repeatedly on the clock's own thread. Its {@code toString}
 * describes what delays the clock.
 */
public interface Pacing {
    /**
     * Returns whether the next step may be taken; may block briefly before it returns false.
     *
     * @param nowNanos the lab's time
     * @param membersWait whether all members wait, but for those that have been running for 250 ms of real time
     * @return true to take the step now
     */
    boolean mayStep(long nowNanos, BooleanSupplier membersWait);

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
            public boolean mayStep(long nowNanos, BooleanSupplier membersWait) {
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
     * Creates a pacing that follows the wall clock, multiplied by a speed.
     *
     * @param speed how many times as fast as real time, above 0
     * @param quiet whether no byte is in transit on any connection; above real time the lab waits for that now and then
     * @param report receives a sentence, once, if the lab does not reach its speed
     */
    static Pacing scaled(double speed, BooleanSupplier quiet, Consumer<String> report) {
        return new ScaledPacing(speed, quiet, new SpeedWatch(speed, report), new ScaledPacing.RealTime() {
            @Override
            public long nanos() {
                return System.nanoTime();
            }

            @Override
            public void pause(long nanos) {
                LockSupport.parkNanos(nanos);
            }
        });
    }
}
