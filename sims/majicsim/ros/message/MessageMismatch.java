package majicsim.ros.message;

/** A received object does not fit its type; the bridge drops it. */
public final class MessageMismatch extends Exception {
    private static final long serialVersionUID = 1;

    /**
     * A mismatch.
     *
     * @param message what does not fit, as the bridge reports it to the caller of a service
     */
    public MessageMismatch(String message) {
        super(message);
    }
}
