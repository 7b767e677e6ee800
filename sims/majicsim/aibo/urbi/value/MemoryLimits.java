package majicsim.aibo.urbi.value;

/** How large a value and how many names programs may make, so that none of them uses up the server's memory. */
public final class MemoryLimits {
    public static final String OUT_OF_MEMORY = "Out of memory";

    /** No string or list may become heavier than this: programs double them. */
    private static final long HEAVIEST_VALUE = 256 * 1024;

    private static final int MOST_NAMES = 20_000;

    private MemoryLimits() {}

    /** Returns the value that an expression has made, if it is not too heavy. */
    public static Value checked(Value made) throws Failure {
        if (made.weight() > HEAVIEST_VALUE) {
            throw Failure.inExpression(OUT_OF_MEMORY);
        }
        return made;
    }

    /** Refuses one more name where programs have made so many groups, functions or the like already. */
    public static void checkNames(int count) throws Failure {
        if (count >= MOST_NAMES) {
            throw Failure.of(OUT_OF_MEMORY);
        }
    }
}
