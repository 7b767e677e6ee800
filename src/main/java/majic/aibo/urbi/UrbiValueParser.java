package majic.aibo.urbi;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * Parses one printed value (URBI sheet 4, "How values print"). Text that is no value is kept as text; throws nothing.
 */
final class UrbiValueParser {
    private static final Pattern NUMBER = Pattern.compile("[+-]?(\\d+(\\.\\d*)?|\\.\\d+)");
    private static final int MAX_NESTING = 64;

    private final byte[] bytes;
    private final int start;
    private final int end;
    private int at;
    private int nesting;

    UrbiValueParser(byte[] bytes, int from, int to) {
        this.bytes = bytes;
        this.start = from;
        this.at = from;
        this.end = to;
    }

    UrbiValue parse() {
        UrbiValue value = value();
        boolean whole = value != null && text(at, end).isBlank();
        return whole ? value : new UrbiValue.Other(text(start, end).stripTrailing());
    }

    private @Nullable UrbiValue value() {
        if (at >= end) {
            return null;
        }
        return switch (bytes[at]) {
            case '"' -> string();
            case '[' -> list();
            default -> word();
        };
    }

    private @Nullable UrbiValue string() {
        StringBuilder text = new StringBuilder();
        for (at++; at < end && bytes[at] != '"'; at++) {
            boolean escape = bytes[at] == '\\' && at + 1 < end;
            text.append(escape ? escaped((char) (bytes[++at] & 0xFF)) : String.valueOf((char) (bytes[at] & 0xFF)));
        }
        if (at++ >= end) {
            return null;
        }
        return new UrbiValue.Str(text.toString());
    }

    private static String escaped(char next) {
        return switch (next) {
            case '"', '\\' -> String.valueOf(next);
            case 'n' -> "\n";
            default -> "\\" + next;
        };
    }

    private @Nullable UrbiValue list() {
        List<UrbiValue> items = new ArrayList<>();
        at++;
        if (++nesting > MAX_NESTING) {
            return null;
        }
        while (at < end && bytes[at] != ']') {
            UrbiValue item = value();
            boolean separated = at < end && (bytes[at] == ',' || bytes[at] == ']');
            if (item == null || !separated) {
                return null;
            }
            items.add(item);
            at += bytes[at] == ',' ? 1 : 0;
        }
        nesting--;
        return at++ < end ? new UrbiValue.Items(items) : null;
    }

    private @Nullable UrbiValue word() {
        int from = at;
        while (at < end && bytes[at] != ',' && bytes[at] != ']' && bytes[at] != '\n') {
            at++;
        }
        String word = text(from, at).strip();
        if (word.startsWith("BIN ") && at < end && bytes[at] == '\n') {
            return binary(List.of(word.split(" +")));
        }
        return number(word);
    }

    private @Nullable UrbiValue binary(List<String> header) {
        int size = NUMBER.matcher(header.get(1)).matches() ? (int) Double.parseDouble(header.get(1)) : -1;
        if (size < 0 || size > end - at - 1) {
            return null;
        }
        byte[] content = Arrays.copyOfRange(bytes, at + 1, at + 1 + size);
        at += 1 + size;
        return new UrbiValue.Binary(header.subList(2, header.size()), content);
    }

    private static @Nullable UrbiValue number(String word) {
        return switch (word) {
            case "inf" -> new UrbiValue.Num(Double.POSITIVE_INFINITY);
            case "-inf" -> new UrbiValue.Num(Double.NEGATIVE_INFINITY);
            case "nan", "-nan" -> new UrbiValue.Num(Double.NaN);
            default -> NUMBER.matcher(word).matches() ? new UrbiValue.Num(Double.parseDouble(word)) : null;
        };
    }

    private String text(int from, int to) {
        return new String(bytes, from, Math.max(0, to - from), StandardCharsets.ISO_8859_1);
    }
}
