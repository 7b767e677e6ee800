package majic.time;

import java.util.function.BooleanSupplier;

/**
 * Determines whether the current thread may wait for a robot's answer or for a listener. A thread must not if it
 * receives all reports of a robot, sends motion commands, or checks the guard condition of a moving robot: there a
 * value that is not available at once is {@code unknown}, and listeners are called on another thread. Drivers check
 * this before they wait in the reader of a parameter.
 */
public final class WaitPolicy {
    private static final ThreadLocal<Boolean> DENIED = ThreadLocal.withInitial(() -> false);

    private static final ThreadLocal<Boolean> OBSERVING = ThreadLocal.withInitial(() -> false);

    private WaitPolicy() {}

    /**
     * Returns whether waiting is allowed.
     *
     * @return false inside of {@link #without}, otherwise true
     */
    public static boolean isAllowed() {
        return !DENIED.get();
    }

    /**
     * Evaluates a condition without waiting.
     *
     * @param condition evaluated on this thread
     * @return its result
     */
    public static boolean without(BooleanSupplier condition) {
        boolean before = DENIED.get();
        DENIED.set(true);
        try {
            return condition.getAsBoolean();
        } finally {
            DENIED.set(before);
        }
    }

    /**
     * Runs a task that must not wait.
     *
     * @param task runs on this thread
     */
    public static void without(Runnable task) {
        without(() -> {
            task.run();
            return true;
        });
    }

    /**
     * Returns whether the current thread only observes.
     *
     * @return true inside of {@link #observing}; reading a value then does not count as interest in it, so drivers that
     *     poll a value only while something reads it must not begin or go on because of this thread
     */
    public static boolean isObserving() {
        return OBSERVING.get();
    }

    /**
     * Runs a task that reads only what robots have reported anyway: it must not wait, and causes no request to a robot.
     *
     * @param task runs on this thread
     */
    public static void observing(Runnable task) {
        boolean before = OBSERVING.get();
        OBSERVING.set(true);
        try {
            without(task);
        } finally {
            OBSERVING.set(before);
        }
    }
}
