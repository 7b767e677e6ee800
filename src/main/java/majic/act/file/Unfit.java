package majic.act.file;

import java.io.IOException;

/**
 * Reports content of a file that no act may have. The message is put behind the file's name: {@code holds a
 * java.net.URL}.
 */
public final class Unfit extends IOException {
    private static final long serialVersionUID = 1;

    public Unfit(String message) {
        super(message);
    }

    public Unfit(String message, Throwable cause) {
        super(message, cause);
    }
}
