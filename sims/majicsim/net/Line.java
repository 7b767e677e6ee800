package majicsim.net;

/** One client's line, as the firmware sees it. Used with the lab's lock held. */
public interface Line {
    /**
     * The address of the other end.
     *
     * @return the client's own address as "host:port", or the path of the pseudo-terminal
     */
    String peer();

    /**
     * Sends one message in one write, after all earlier ones; faults and jitter apply. Never blocks: what a client does
     * not read is kept for a while and then dropped. Does nothing on a closed line.
     *
     * @param message the bytes, not changed afterwards
     */
    void send(byte[] message);

    /**
     * What was sent and is kept because the client does not read it.
     *
     * @return bytes; 0 on a line that keeps none
     */
    default int unsent() {
        return 0;
    }

    /**
     * Closes the line once everything sent so far has gone out. A pseudo-terminal cannot be closed from this side and
     * stays open.
     */
    void close();

    /**
     * The speed that the client has set at its end.
     *
     * @return bits a second; 0 on a line that has none, or if it is not known
     */
    default int baud() {
        return 0;
    }

    /**
     * Whether messages can still be sent.
     *
     * @return false once it was closed from either side
     */
    boolean isOpen();
}
