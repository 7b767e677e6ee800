package majic;

import majic.bot.TimeSource;

/**
 * A stepped clock without a lab behind it: time passes at once when every thread that lives by it waits. The thread that
 * makes it lives by it.
 */
public final class TestClock implements AutoCloseable {
    private static final long STEP_NANOS = 1_000_000;

    private final LabClock clock = new LabClock(new CountedSteps(), Pacing.stepped(() -> true));
    private final TimeSource.Membership membership = clock.join();

    public TestClock() {
        clock.start();
    }

    public TimeSource time() {
        return clock;
    }

    @Override
    public void close() {
        membership.close();
        clock.close();
    }

    private static final class CountedSteps implements LabClock.Steps {
        private volatile long nanos;

        @Override
        public void step() {
            nanos += STEP_NANOS;
        }

        @Override
        public long nanos() {
            return nanos;
        }
    }
}
