package majic.act;

import majic.bot.BotException;

/** Reports that an act cannot be made, read or loaded. The message is one sentence that names the file or class. */
public class ActException extends BotException {
    private static final long serialVersionUID = 1;

    /**
     * Creates an exception with a message.
     *
     * @param message what is wrong with which file or class
     */
    public ActException(String message) {
        super(message);
    }

    /**
     * Creates an exception with a message and a cause.
     *
     * @param message what is wrong with which file or class
     * @param cause the underlying exception
     */
    public ActException(String message, Throwable cause) {
        super(message, cause);
    }
}
