package majic.hemisson.line;

import java.io.IOException;

/**
 * Receives the events of a conversation; called by the reader thread, or by the thread that calls
 * {@link Conversation#tick}.
 */
public interface ConversationListener {
    /** An exchange was answered. */
    void answered(Exchange exchange);

    /**
     * A question was not answered, or was refused; it may be sent again.
     *
     * @param inMotion whether the robot may have been moving then; it may have been stopped meanwhile
     */
    void missed(Exchange exchange, boolean inMotion);

    /** The robot was switched on or reset during the session; its motors are off. */
    void wasReset();

    /** The link has failed. */
    void broken(IOException cause);
}
