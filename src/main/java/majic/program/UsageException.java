package majic.program;

/** Reports that the command line requests something impossible; the message is the sentence for the user. */
public final class UsageException extends RuntimeException {
    private static final long serialVersionUID = 1;

    public UsageException(String message) {
        super(message);
    }
}
