package majicsim.aibo.urbi.value;

/** The largest value and the largest number of names of programs, so that none of them uses up the server's memory. */
public final class MemoryLimits {
    public static final String OUT_OF_MEMORY = "Out of memory";

    /** The largest size of a string or list, because programs can double them repeatedly. */
    private static final long HEAVIEST_VALUE = 256 * 1024;

    private static final int MOST_NAMES = 20_000;

    private MemoryLimits() {}

    /** Returns the value of an expression if it is not too large. */
    public static Value checked(Value made) throws Failure {
        if (made.weight() > HEAVIEST_VALUE) {
            throw Failure.inExpression(OUT_OF_MEMORY);
        }
        return made;
    }

    /** Refuses a further name if programs have made too many groups, functions or similar. */
    public static void checkNames(int count) throws Failure {
        if (count >= MOST_NAMES) {
            throw Failure.of(OUT_OF_MEMORY);
        }
    }
}
