package majicsim.hemisson.firmware;

/** Thrown for a module command whose answer is an error reply. */
final class ErrorReplyException extends Exception {
    private static final long serialVersionUID = 1L;

    private final ErrorReply error;

    ErrorReplyException(ErrorReply error) {
        super(error.toString());
        this.error = error;
    }

    ErrorReply error() {
        return error;
    }
}
