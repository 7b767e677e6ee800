package majic.driver;

import java.io.IOException;
import java.util.function.Consumer;

/**
 * Decodes and handles what a link receives. Called only by the link's reader thread, which must not wait for an answer.
 *
 * @param <M> a message: a packet, a line
 */
public interface LinkHandler<M> {
    /**
     * Decodes bytes to messages; keeps a partial message for the next call.
     *
     * @param bytes read from the link, from index 0 on; reused after the call
     * @param count how many, at least 1
     * @param messages receives each whole message, in order; throws nothing
     */
    void decode(byte[] bytes, int count, Consumer<M> messages);

    /**
     * Handles one message. What it throws is logged and does not end the link.
     *
     * @param message as decoded
     */
    void received(M message);

    /**
     * Handles the end of the link. Called once, after everything else; must close the link and wake all waiting
     * threads.
     *
     * @param cause why; its message is half a sentence, such as "the robot closed it"
     */
    void ended(IOException cause);
}
