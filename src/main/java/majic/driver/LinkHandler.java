package majic.driver;

import java.io.IOException;
import java.util.function.Consumer;

/**
 * What a driver does with what a link brings. Called by the link's reader thread only, which never waits for an answer.
 *
 * @param <M> a message: a packet, a line
 */
public interface LinkHandler<M> {
    /**
     * Takes bytes apart; keeps what is not yet a whole message.
     *
     * @param bytes read from the link, from index 0 on; reused after the call
     * @param count how many, at least 1
     * @param messages takes each whole message, in order; throws nothing
     */
    void decode(byte[] bytes, int count, Consumer<M> messages);

    /**
     * Takes in one message. What it throws is logged and ends nothing.
     *
     * @param message as decoded
     */
    void received(M message);

    /**
     * The link is dead. Called once, after everything else; closes the link and wakes all that wait for it.
     *
     * @param cause why; its message is half a sentence, such as "the robot closed it"
     */
    void ended(IOException cause);
}
