package majic.hemisson.line;

import java.io.IOException;

/** Hears how a conversation goes, on the thread of the reader or of whoever looks for overdue answers. */
public interface ConversationListener {
    /** An exchange came to its good end. */
    void answered(Exchange exchange);

    /**
     * A question was not answered, or was refused; it may be asked again.
     *
     * @param inMotion whether the robot may have been moving then; by now it may have been stopped
     */
    void missed(Exchange exchange, boolean inMotion);

    /** The robot was switched on or reset in mid session; it stands. */
    void wasReset();

    /** The link is dead. */
    void broken(IOException cause);
}
