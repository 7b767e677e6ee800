package majic.velocity;

/**
 * A contact, or another reason for which a base cannot go on, as its sensors report it. Immutable.
 *
 * @param what it is, as half a sentence: "front left bumper pressed", "cliff at the left"
 * @param side which motions it prevents
 * @param reflex whether the base reacts by itself, by a stop or a motion of its own
 * @param atNanos when it was reported last, on the driver's clock
 */
public record Obstruction(String what, Side side, boolean reflex, long atNanos) {
    /** Where it is. */
    public enum Side {
        /** Prevents motions ahead. */
        FRONT,
        /** Prevents motions back. */
        REAR,
        /** Prevents every motion, such as a wheel that hangs free. */
        ALL
    }
}
