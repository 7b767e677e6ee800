package majic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.function.LongConsumer;
import java.util.function.Supplier;
import majic.link.Links;
import majic.simulation.LabClock;
import majic.simulation.Pacing;
import majic.simulation.TransitCheck;
import majic.time.Signal;
import majic.time.TimeSource;
import majicsim.net.LineCount;

/**
 * A stepped clock without a lab: time advances at once when every registered thread waits. The creating thread is
 * registered.
 */
public final class TestClock implements AutoCloseable {
    private static final long STEP_NANOS = 1_000_000;
    private static final double LOOK_AGAIN_S = 0.005;

    private final LabClock clock;
    private final TimeSource.Membership membership;

    public TestClock() {
        this(nanos -> {}, () -> true);
    }

    /**
     * Creates a clock that also drives a component without its own thread.
     *
     * @param onStep receives the time at each step of a millisecond
     * @param quiet whether no data is in transit on any line; time does not advance while there is
     */
    public TestClock(LongConsumer onStep, BooleanSupplier quiet) {
        AtomicLong nanos = new AtomicLong();
        clock = new LabClock(STEP_NANOS, () -> onStep.accept(nanos.addAndGet(STEP_NANOS)), Pacing.stepped(quiet));
        membership = clock.join();
        clock.start();
    }

    /**
     * Creates a clock for the peer at an address and its clients. Time does not advance while data is in transit
     * between them, so the speed of the computer does not matter.
     */
    public static TestClock between(String address, Supplier<List<LineCount>> lines) {
        return new TestClock(nanos -> {}, new TransitCheck(Links::traffic, lines, Set.of(address)));
    }

    public TimeSource time() {
        return clock;
    }

    /** Lets time pass until a condition is true; without a limit of its own. */
    public void until(BooleanSupplier so) {
        Signal never = clock.signal();
        try {
            while (!never.await(so, LOOK_AGAIN_S)) {
                assertThat(Thread.currentThread().isInterrupted()).isFalse();
            }
        } catch (InterruptedException e) {
            throw new IllegalStateException("did not come to be so in time", e);
        }
    }

    /** Starts a task on its own thread, registered with this clock. */
    public <T> CompletableFuture<T> aside(Supplier<T> work) {
        CompletableFuture<T> outcome = new CompletableFuture<>();
        Runnable body = () -> outcome.completeAsync(work, Runnable::run);
        clock.thread("aside", body).start();
        return outcome;
    }

    /** Starts a task without a result, as {@link #aside(Supplier)} does. */
    public CompletableFuture<Void> aside(Runnable work) {
        return aside(() -> {
            work.run();
            return null;
        });
    }

    /** Lets time pass until a task is done; throws its exception as {@link CompletableFuture#join} does. */
    public <T> T join(CompletableFuture<T> begun) {
        until(begun::isDone);
        return begun.join();
    }

    @Override
    public void close() {
        membership.close();
        clock.close();
    }
}
