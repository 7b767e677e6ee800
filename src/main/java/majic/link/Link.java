package majic.link;

import java.io.IOException;

/**
 * A two-way stream of bytes. One thread reads; any thread may write, and each write is sent in one piece.
 *
 * <p>A write has a deadline of {@value #WRITE_DEADLINE_MS} ms, after which the link is dead; no call of {@link #write}
 * takes longer. Reading and the write deadline run on the system's clock, as the wire does.
 */
public interface Link extends AutoCloseable {
    /** How long a write may take, the wait for other writers included, ms. */
    int WRITE_DEADLINE_MS = 1000;

    /**
     * Opens the link, once; a link that was closed does not open any more.
     *
     * @param timeoutMs how long to try at most, ms
     * @throws IOException if it cannot be opened; the message is a sentence with the reason and advice
     */
    void open(int timeoutMs) throws IOException;

    /**
     * Waits for bytes. For one reader thread only.
     *
     * @param buffer receives them from index 0 on
     * @return how many came, at least 1; −1 when the peer has closed or the link is closed
     * @throws IOException if the link broke; it is dead then
     */
    int read(byte[] buffer) throws IOException;

    /**
     * Writes one message, in one piece.
     *
     * @param message all of it
     * @throws IOException if it could not be written within the deadline; the link is dead then and has been closed
     */
    void write(byte[] message) throws IOException;

    /**
     * Closes the link after everything was written; wakes the reader, and ends an {@link #open} in progress. Does
     * nothing the second time.
     */
    @Override
    void close();

    /** Closes the link at once and discards what was not yet delivered. */
    void abort();

    /**
     * Changes the speed of a serial line for what is read and written from now on. Bytes written before may still be
     * sent at the old speed.
     *
     * @param baud the new speed, baud
     * @return false if the link has no speed; nothing happens then
     * @throws IOException if the port refuses it, or is closed
     */
    default boolean setBaud(int baud) throws IOException {
        return false;
    }

    /**
     * The address.
     *
     * @return the address as a user would write it: {@code tcp:10.0.0.5:8101}, {@code serial:COM3}
     */
    String address();

    /**
     * The traffic so far.
     *
     * @return the counts now
     */
    Traffic traffic();
}
