package majic.aibo.urbi;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** Formats answers of the dog for the user. */
public final class UrbiText {
    private UrbiText() {}

    /** One message. */
    public static String of(UrbiMessage.Body body) {
        if (body instanceof UrbiMessage.Result result) {
            return of(result.value());
        }
        if (body instanceof UrbiMessage.Failure failure) {
            return "!!! " + failure.text();
        }
        if (body instanceof UrbiMessage.Info info) {
            return info.text();
        }
        return body instanceof UrbiMessage.Continued further ? further.text() : "";
    }

    private static String of(UrbiValue value) {
        if (value instanceof UrbiValue.Num number) {
            return String.format(Locale.ROOT, "%.6f", number.amount());
        }
        if (value instanceof UrbiValue.Str text) {
            return '"' + text.text() + '"';
        }
        if (value instanceof UrbiValue.Items list) {
            return all(list.items());
        }
        if (value instanceof UrbiValue.Binary binary) {
            return "BIN " + binary.bytes().length + " " + String.join(" ", binary.words());
        }
        return ((UrbiValue.Other) value).text();
    }

    private static String all(List<UrbiValue> items) {
        return items.stream().map(UrbiText::of).collect(Collectors.joining(", ", "[", "]"));
    }
}
