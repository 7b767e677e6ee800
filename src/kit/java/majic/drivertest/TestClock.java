package majic.drivertest;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.function.LongConsumer;
import java.util.function.Supplier;
import majic.lab.LabClock;
import majic.lab.Pacing;
import majic.time.Signal;
import majic.time.TimeSource;

/**
 * A clock that steps: its time advances by 1 ms as soon as every thread that uses it waits at one of its signals, so
 * tests neither take the time that they test nor depend on how busy the computer is. The thread that creates the clock
 * uses it until it closes the clock; others use it if the clock has made them.
 */
public final class TestClock implements AutoCloseable {
    private static final long STEP_NANOS = 1_000_000;
    private static final double LOOK_AGAIN_S = 0.005;

    private final LabClock clock;
    private final TimeSource.Membership membership;

    /** Creates a clock for a test without connections. */
    public TestClock() {
        this(nanos -> {}, () -> true);
    }

    /**
     * Creates a clock that also drives a component without its own thread.
     *
     * @param onStep receives the time at each step, ns since the creation, on the clock's thread
     * @param quiet whether no data is in transit on any connection; time does not advance while there is
     */
    public TestClock(LongConsumer onStep, BooleanSupplier quiet) {
        AtomicLong nanos = new AtomicLong();
        clock = new LabClock(STEP_NANOS, () -> onStep.accept(nanos.addAndGet(STEP_NANOS)), Pacing.stepped(quiet));
        membership = clock.join();
        clock.start();
    }

    /**
     * Returns the clock as drivers, teams and acts use it.
     *
     * @return the same object at each call
     */
    public TimeSource time() {
        return clock;
    }

    /**
     * Lets time pass until a condition is true; without a limit of its own.
     *
     * @param condition tested every 5 ms of this clock
     */
    public void until(BooleanSupplier condition) {
        Signal never = clock.signal();
        try {
            while (!never.await(condition, LOOK_AGAIN_S)) {
                if (Thread.currentThread().isInterrupted()) {
                    throw new InterruptedException();
                }
            }
        } catch (InterruptedException e) {
            throw new IllegalStateException("the condition did not become true in time", e);
        }
    }

    /**
     * Starts a task on its own thread, which uses this clock.
     *
     * @param <T> its result
     * @param work the task
     * @return completed with the result of the task, or with what it throws
     */
    public <T> CompletableFuture<T> aside(Supplier<T> work) {
        CompletableFuture<T> outcome = new CompletableFuture<>();
        Runnable body = () -> outcome.completeAsync(work, Runnable::run);
        clock.thread("aside", body).start();
        return outcome;
    }

    /**
     * Starts a task without a result, as {@link #aside(Supplier)} does.
     *
     * @param work the task
     * @return completed when the task has ended
     */
    public CompletableFuture<Void> aside(Runnable work) {
        return aside(() -> {
            work.run();
            return null;
        });
    }

    /**
     * Lets time pass until a task is done; throws its exception as {@link CompletableFuture#join} does.
     *
     * @param <T> its result
     * @param begun a task of {@link #aside(Supplier)}
     * @return its result
     */
    public <T> T join(CompletableFuture<T> begun) {
        until(begun::isDone);
        return begun.join();
    }

    /** Ends the clock. To be called on the thread that created it. */
    @Override
    public void close() {
        membership.close();
        clock.close();
    }
}
