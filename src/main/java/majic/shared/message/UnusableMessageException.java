package majic.shared.message;

import majic.bot.BotException;

/**
 * A message of another program that cannot be used; the sentence states what is wrong in it and what would be right.
 */
public final class UnusableMessageException extends BotException {
    private static final long serialVersionUID = 1;

    /**
     * Creates the exception.
     *
     * @param message what is wrong, and what would be right
     */
    public UnusableMessageException(String message) {
        super(message);
    }
}
