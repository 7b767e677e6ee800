package majic.ros.websocket;

import java.io.IOException;
import org.jspecify.annotations.Nullable;

/** A server was reached that does not answer as a WebSocket server does. */
public final class NotWebSocket extends IOException {
    private static final long serialVersionUID = 1;

    private final @Nullable String line;

    NotWebSocket(@Nullable String line) {
        super(line == null ? "it closed the connection without an answer" : "it answers \"" + line + "\"");
        this.line = line;
    }

    /**
     * Returns the beginning of the answer.
     *
     * @return the first readable line; null if there is none
     */
    public @Nullable String line() {
        return line;
    }

    /**
     * Returns whether a web server answered.
     *
     * @return true for an answer in HTTP
     */
    public boolean isWebServer() {
        return line != null && line.startsWith("HTTP/");
    }
}
