package majic.program;

/** The command line asked for something that cannot be; the message is the sentence for the user. */
public final class UsageException extends RuntimeException {
    private static final long serialVersionUID = 1;

    public UsageException(String message) {
        super(message);
    }
}
