package majic.act.file;

import java.io.IOException;

/**
 * Reports content of a file that no act may have. The message is put behind the file's name: {@code holds a
 * java.net.URL}.
 */
public final class InvalidActException extends IOException {
    private static final long serialVersionUID = 1;

    public InvalidActException(String message) {
        super(message);
    }

    public InvalidActException(String message, Throwable cause) {
        super(message, cause);
    }
}
