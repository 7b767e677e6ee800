package majic.time;

import java.util.function.BooleanSupplier;

/**
 * Whether the current thread may wait for a robot's answer or for a listener. A thread that receives all reports of a
 * robot must not, nor one that sends motion commands, nor one that checks the guard of a moving robot: what
 * cannot be had at once is {@code unknown} to them, and listeners are called on a thread of their own. Drivers ask here
 * before they wait in the reader of a parameter.
 */
public final class WaitPolicy {
    private static final ThreadLocal<Boolean> DENIED = ThreadLocal.withInitial(() -> false);

    private WaitPolicy() {}

    /**
     * Whether waiting is allowed.
     *
     * @return true but inside of {@link #without}
     */
    public static boolean isAllowed() {
        return !DENIED.get();
    }

    /**
     * Looks at something without waiting for it.
     *
     * @param look what to ask, on this thread
     * @return what it answered
     */
    public static boolean without(BooleanSupplier look) {
        boolean before = DENIED.get();
        DENIED.set(true);
        try {
            return look.getAsBoolean();
        } finally {
            DENIED.set(before);
        }
    }

    /**
     * Does something that must not wait.
     *
     * @param deed what to do, on this thread
     */
    public static void without(Runnable deed) {
        without(() -> {
            deed.run();
            return true;
        });
    }
}
