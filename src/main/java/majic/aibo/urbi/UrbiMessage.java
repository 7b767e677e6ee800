package majic.aibo.urbi;

import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;

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

    /**
     * Reads a message from its parts.
     *
     * @param timeMs the server's clock, ms
     * @param tag null or empty when the server names none
     * @param text what stands behind the prefix, without binary content
     */
    public static UrbiMessage of(long timeMs, @Nullable String tag, String text) {
        byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
        return new UrbiMessage(timeMs, tagOf(tag), UrbiBodies.parse(bytes, 0, bytes.length));
    }

    /** Makes a message of a value; as {@link #of(long, String, String)}. */
    public static UrbiMessage of(long timeMs, @Nullable String tag, UrbiValue value) {
        return new UrbiMessage(timeMs, tagOf(tag), new Result(value));
    }

    private static String tagOf(@Nullable String tag) {
        return tag == null || tag.isEmpty() ? NO_TAG : tag;
    }

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
