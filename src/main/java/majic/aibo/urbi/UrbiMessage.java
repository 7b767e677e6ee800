package majic.aibo.urbi;

/**
 * One message of an URBI server. Immutable.
 *
 * @param timeMs the server's clock, ms since it started
 * @param tag the tag of the command it answers; {@value #NO_TAG} when the server names none
 * @param body its content
 */
public record UrbiMessage(long timeMs, String tag, Body body) {
    /** The tag of answers to commands that had none. */
    static final String NO_TAG = "notag";

    /** Whether it has the tag of syntax errors and of the server's own errors (URBI sheet 11). */
    boolean isError() {
        return tag.equals("error");
    }

    /** The content of a message. */
    public sealed interface Body {}

    /**
     * {@code *** …}: begin, end, pong, banner, echo.
     *
     * @param text without the asterisks
     */
    public record Info(String text) implements Body {}

    /**
     * A further line of the information before it, which came without a prefix.
     *
     * @param text the line
     */
    record Continued(String text) implements Body {}

    /**
     * {@code !!! …}: what went wrong.
     *
     * @param text without the exclamation marks
     */
    public record Failure(String text) implements Body {}

    /**
     * A value.
     *
     * @param value what was printed
     */
    public record Result(UrbiValue value) implements Body {}
}
