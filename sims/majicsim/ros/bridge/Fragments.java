package majicsim.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import majicsim.ros.message.JsonForm;
import majicsim.ros.message.MessageMismatch;
import org.jspecify.annotations.Nullable;

/**
 * Messages in parts: those of a client are put together, and those to it are divided when it asked for this (sheet 3).
 */
final class Fragments {
    /** More parts than this are dropped, as the real bridge drops those that are too old. */
    private static final int MOST_PARTS = 10_000;

    private final Map<String, Map<Integer, String>> parts = new HashMap<>();
    private int size;

    void size(int characters) {
        size = characters;
    }

    boolean isDividing(int length) {
        return size > 0 && length > size;
    }

    /** Takes one part; returns the whole text when it is complete, otherwise null. */
    @Nullable
    String take(JsonNode message) throws MessageMismatch {
        String id = Fields.id(message);
        int total = Fields.number(message, "total", -1);
        int number = Fields.number(message, "num", -1);
        if (id.isEmpty() || total < 1 || number < 0 || number >= total) {
            throw new MessageMismatch("a fragment needs id, num and total");
        }
        Map<Integer, String> known = parts.computeIfAbsent(id, key -> new TreeMap<>());
        known.put(number, Fields.text(message, "data"));
        if (known.size() == total) {
            parts.remove(id);
            return String.join("", known.values());
        }
        if (known.size() > MOST_PARTS) {
            parts.remove(id);
        }
        return null;
    }

    /** Divides a message. The total is not a whole number: length by size, plus 1 (as captured). */
    List<JsonForm.Content> divided(@Nullable JsonNode id, String text) {
        double total = text.length() / (double) size + 1;
        List<JsonForm.Content> divided = new ArrayList<>();
        for (int from = 0; from < text.length(); from += size) {
            String data = text.substring(from, Math.min(text.length(), from + size));
            int number = divided.size();
            divided.add(to -> {
                to.writeStartObject();
                to.writeStringField("op", "fragment");
                if (id == null || id.isMissingNode()) {
                    to.writeNumberField("id", 0);
                } else {
                    JsonObjects.writeId(to, id);
                }
                to.writeStringField("data", data);
                to.writeNumberField("num", number);
                to.writeNumberField("total", total);
                to.writeEndObject();
            });
        }
        return divided;
    }
}
