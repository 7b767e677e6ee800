package signatures;

/** Thrown by every method of the signatures here: the vendor's library is what does something. */
public final class SignatureOnly extends UnsupportedOperationException {
    private static final long serialVersionUID = 1;

    /** Says so. */
    public SignatureOnly() {
        super("this is a signature to compile against, not the vendor's library");
    }
}
