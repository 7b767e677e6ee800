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
        return new UrbiMessage(timeMs, tagOf(tag), Body.parse(bytes, 0, bytes.length));
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

    /** The content of a message: information, an error, or a value (URBI sheet 4). */
    public sealed interface Body {
        /** Reads the body between two indices; the line feed at its end may be there or not. */
        static Body parse(byte[] bytes, int from, int to) {
            String mark = new String(bytes, from, Math.min(3, to - from), StandardCharsets.ISO_8859_1);
            return switch (mark) {
                case "***" -> new Info(rest(bytes, from, to));
                case "!!!" -> new Failure(rest(bytes, from, to));
                default -> new Result(new UrbiValueParser(bytes, from, to).parse());
            };
        }

        private static String rest(byte[] bytes, int from, int to) {
            String text = new String(bytes, from + 3, to - from - 3, StandardCharsets.ISO_8859_1).stripTrailing();
            return text.startsWith(" ") ? text.substring(1) : text;
        }
    }

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
