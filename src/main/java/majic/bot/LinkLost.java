package majic.bot;

/**
 * The connection to a robot broke. The robot's page describes what the robot does meanwhile; nothing resumes by itself.
 */
public class LinkLost extends BotException {
    private static final long serialVersionUID = 1;

    /**
     * A lost connection.
     *
     * @param message how it was lost, as half a sentence
     */
    public LinkLost(String message) {
        super(message);
    }

    /**
     * A lost connection with its cause.
     *
     * @param message how it was lost, as half a sentence
     * @param cause the exception of the system
     */
    public LinkLost(String message, Throwable cause) {
        super(message, cause);
    }
}
