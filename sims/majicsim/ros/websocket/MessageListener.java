package majicsim.ros.websocket;

/** Receives the messages of one connection. Called with the lab's lock held, in the order of arrival. */
public interface MessageListener {
    /** Reports that the handshake has succeeded; messages can be sent from now on. */
    void opened();

    /**
     * Reports a message.
     *
     * @param payload its content; the listener may keep the array
     * @param isText whether it came as text; then it is UTF-8
     */
    void received(byte[] payload, boolean isText);
}
