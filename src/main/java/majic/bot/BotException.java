package majic.bot;

/** Something a robot could not do. The message is one sentence for the user; the cause, if any, is for the log. */
public class BotException extends RuntimeException {
    private static final long serialVersionUID = 1;

    /**
     * A failure with its sentence.
     *
     * @param message what went wrong and what would be right
     */
    public BotException(String message) {
        super(message);
    }

    /**
     * A failure with its sentence and what caused it.
     *
     * @param message what went wrong and what would be right
     * @param cause what happened below
     */
    public BotException(String message, Throwable cause) {
        super(message, cause);
    }
}
