package majic.ros.bridge;

/**
 * The message that is arriving on a connection. Immutable.
 *
 * @param bytes what has arrived of it; 0 between messages
 * @param of its length as far as it is known, bytes
 * @param leftOut whether the newest message that was complete was left out, because it was too long
 */
public record Arriving(long bytes, long of, boolean leftOut) {
    /** No message. */
    public static final Arriving NOTHING = new Arriving(0, 0, false);
}
