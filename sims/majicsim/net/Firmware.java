package majicsim.net;

/** What a simulated robot is to its lines. Every call comes with the lab's lock held, so a firmware is single-threaded. */
public interface Firmware {
    /**
     * A client has come.
     *
     * @param line its line, open
     */
    default void connected(Line line) {}

    /**
     * Bytes have come, in whatever pieces.
     *
     * @param line where from
     * @param bytes at least one; the firmware may keep the array
     */
    void received(Line line, byte[] bytes);

    /**
     * A line has ended, from either end. Called once for every line that was connected; nothing can be sent to it any more.
     *
     * @param line the line, closed
     */
    default void disconnected(Line line) {}

    /**
     * Lab time has gone on; the world has just been moved by it.
     *
     * @param seconds the lab's fixed step
     */
    void step(double seconds);
}
