package majic.time;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;

/**
 * How long a test waits on the wall clock for something that has to happen. Long, because a busy computer is slow; a
 * wait ends as soon as it has happened. Shorter than the time after which a hanging test is ended, so that the failure
 * names what did not happen.
 */
public final class WaitLimit {
    public static final int SECONDS = 120;
    public static final int MS = SECONDS * 1000;

    private static final long INTERVAL_NANOS = 100_000;

    private WaitLimit() {}

    /**
     * Waits for a condition that no latch or signal reports, and fails if it does not become true in time.
     *
     * @param what names it in the failure
     * @param condition evaluated repeatedly, on the calling thread
     */
    public static void until(String what, BooleanSupplier condition) {
        long startNanos = System.nanoTime();
        while (!condition.getAsBoolean()) {
            if (System.nanoTime() - startNanos > TimeUnit.SECONDS.toNanos(SECONDS)) {
                throw new AssertionError("timed out waiting for " + what);
            }
            if (Thread.currentThread().isInterrupted()) {
                throw new AssertionError("interrupted while waiting for " + what);
            }
            LockSupport.parkNanos(INTERVAL_NANOS);
        }
    }

    /**
     * Waits for a latch, and fails if it is not released in time.
     *
     * @param what names it in the failure
     * @param latch released by another thread
     */
    public static void await(String what, CountDownLatch latch) {
        try {
            if (!latch.await(SECONDS, TimeUnit.SECONDS)) {
                throw new AssertionError("timed out waiting for " + what);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new AssertionError("interrupted while waiting for " + what, e);
        }
    }

    /**
     * Waits for a task, and fails if it does not end in time. Unlike {@code join} alone, which no interrupt ends.
     *
     * @param <T> its result
     * @param what names it in the failure
     * @param task completed by another thread
     * @return its result
     */
    public static <T> T join(String what, CompletableFuture<T> task) {
        return task.copy()
                .orTimeout(SECONDS, TimeUnit.SECONDS)
                .exceptionallyCompose(problem -> CompletableFuture.failedFuture(
                        problem instanceof TimeoutException
                                ? new AssertionError("timed out waiting for " + what)
                                : problem))
                .join();
    }
}
