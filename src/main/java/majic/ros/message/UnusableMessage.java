package majic.ros.message;

import majic.bot.BotException;

/** A message of a topic does not have the content of its type; the message names the field. */
public final class UnusableMessage extends BotException {
    private static final long serialVersionUID = 1;

    /**
     * Creates the exception.
     *
     * @param message which field is wrong, and what it has to be, as half a sentence
     */
    public UnusableMessage(String message) {
        super(message);
    }
}
