package majic.act;

import majic.bot.BotException;

/** An act that cannot be made, read or loaded. The message is one sentence that names the file or class. */
public class ActException extends BotException {
    private static final long serialVersionUID = 1;

    /**
     * A failure with its sentence.
     *
     * @param message what is wrong with which file or class
     */
    public ActException(String message) {
        super(message);
    }

    /**
     * A failure with its sentence and what caused it.
     *
     * @param message what is wrong with which file or class
     * @param cause what happened below
     */
    public ActException(String message, Throwable cause) {
        super(message, cause);
    }
}
