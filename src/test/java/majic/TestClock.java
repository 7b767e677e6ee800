package majic;

import java.util.function.BooleanSupplier;
import java.util.function.LongConsumer;
import majic.bot.TimeSource;

/**
 * A stepped clock without a lab behind it: time passes at once when every thread that lives by it waits. The thread that
 * makes it lives by it.
 */
public final class TestClock implements AutoCloseable {
    private static final long STEP_NANOS = 1_000_000;

    private final LabClock clock;
    private final TimeSource.Membership membership;

    public TestClock() {
        this(nanos -> {}, () -> true);
    }

    /**
     * One that something else lives by too, without a thread of its own.
     *
     * @param onStep told the time at each step of a millisecond
     * @param quiet whether nothing is under way on any line; time stands still meanwhile
     */
    public TestClock(LongConsumer onStep, BooleanSupplier quiet) {
        clock = new LabClock(new CountedSteps(onStep), Pacing.stepped(quiet));
        membership = clock.join();
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
        private final LongConsumer onStep;
        private volatile long nanos;

        CountedSteps(LongConsumer onStep) {
            this.onStep = onStep;
        }

        @Override
        public void step() {
            nanos += STEP_NANOS;
            onStep.accept(nanos);
        }

        @Override
        public long nanos() {
            return nanos;
        }
    }
}
