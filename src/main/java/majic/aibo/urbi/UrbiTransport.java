package majic.aibo.urbi;

import java.io.IOException;

/**
 * Carries commands to an URBI server and messages from it, over one connection. Any thread may write; each write is
 * sent in one piece, and takes no longer than that of a {@link majic.link.Link}.
 */
public interface UrbiTransport {
    /** Receives what a transport delivers, on one thread of its own, which must not wait for an answer. */
    interface Receiver {
        /** Handles one message. What it throws is logged and does not end the connection. */
        void received(UrbiMessage message);

        /**
         * Handles the end of the connection. Called once, after everything else.
         *
         * @param cause why; its message is half a sentence, such as "the dog closed it"
         */
        void ended(IOException cause);
    }

    /** Makes transports to servers, without connecting. */
    @FunctionalInterface
    interface Maker {
        /**
         * Makes the transport to a server.
         *
         * @param host its name or address
         * @param port its TCP port
         */
        UrbiTransport make(String host, int port);
    }

    /**
     * Connects, once, and delivers messages from then on.
     *
     * @param timeoutMs how long to try at most, ms
     * @param name of the connection, for threads and the log
     * @param receiver receives the messages
     * @throws IOException if it cannot be opened; the message is a sentence with the reason and advice
     */
    void open(int timeoutMs, String name, Receiver receiver) throws IOException;

    /**
     * Writes bytes.
     *
     * @throws IOException if they could not be written within the deadline; the connection ends then
     */
    void write(byte[] bytes) throws IOException;

    /** Closes after everything was written. Does nothing the second time. */
    void close();

    /** Closes at once and discards what was not yet delivered. */
    void abort();
}
