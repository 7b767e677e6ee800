package majic.act;

import java.io.IOException;

/** Something in a file that no act may have. The message goes behind the file's name: {@code holds a java.net.URL}. */
final class Unfit extends IOException {
    private static final long serialVersionUID = 1;

    Unfit(String message) {
        super(message);
    }

    Unfit(String message, Throwable cause) {
        super(message, cause);
    }
}
