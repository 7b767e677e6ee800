package majic.aibo.urbi;

import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * The prefix of each message: {@code [00012345:tag] } on 1.0, {@code [00012345] } on 1.5 (URBI sheet 4).
 *
 * @param timeMs the server's clock
 * @param tag whose message it is
 */
record UrbiPrefix(long timeMs, String tag) {
    /** The server itself cuts a prefix at 1 KiB. */
    static final int MAX_LENGTH = 1024;

    private static final Pattern SHAPE = Pattern.compile("\\[(\\d{1,18})(?::([^\\]]*))?\\]");

    /** As servers print it: at least eight digits. */
    private static final Pattern WITHIN_BYTES = Pattern.compile("\\[\\d{8,18}(?::[\\w.]{1,64})?\\] ?");

    /** The index of the first prefix within bytes that were taken for something else; −1 if there is none. */
    static int find(byte[] bytes, int from, int to) {
        Matcher prefix = WITHIN_BYTES.matcher(new String(bytes, from, to - from, StandardCharsets.ISO_8859_1));
        return prefix.find() ? from + prefix.start() : -1;
    }

    /** Reads the bytes up to and including the first closing bracket; null if they are no prefix. */
    static @Nullable UrbiPrefix parse(byte[] bytes, int length) {
        if (length > MAX_LENGTH) {
            return null;
        }
        Matcher shape = SHAPE.matcher(new String(bytes, 0, length, StandardCharsets.ISO_8859_1));
        if (!shape.matches()) {
            return null;
        }
        String tag = shape.group(2);
        return new UrbiPrefix(Long.parseLong(shape.group(1)), tag == null || tag.isEmpty() ? UrbiMessage.NO_TAG : tag);
    }
}
