package majic.mavlink.session;

/**
 * The newest message of its kind. Immutable.
 *
 * @param <T> the message
 * @param value what it says
 * @param atNanos when it arrived, on the driver's clock
 */
public record Received<T>(T value, long atNanos) {}
