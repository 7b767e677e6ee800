package majicsim.aibo.urbi;

/** How large a value and how many names programs may make, so that none of them uses up the server's memory. */
final class MemoryLimits {
    static final String OUT_OF_MEMORY = "Out of memory";

    /** No string or list may become heavier than this: programs double them. */
    private static final long HEAVIEST_VALUE = 256 * 1024;

    private static final int MOST_NAMES = 20_000;

    private MemoryLimits() {}

    /** Returns the value that an expression has made, if it is not too heavy. */
    static Value checked(Value made) throws Failure {
        if (made.weight() > HEAVIEST_VALUE) {
            throw Failure.inExpression(OUT_OF_MEMORY);
        }
        return made;
    }

    /** Refuses one more name where programs have made so many groups, functions or the like already. */
    static void checkNames(int count) throws Failure {
        if (count >= MOST_NAMES) {
            throw Failure.of(OUT_OF_MEMORY);
        }
    }
}
