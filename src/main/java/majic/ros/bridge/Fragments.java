package majic.ros.bridge;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Joins the fragments of messages. MAJIC asks for none, but ROS 2 servers fragment long messages unasked (rosbridge
 * sheet 2). Bounded: the oldest incomplete message is given up when there are too many or too much. Used by one thread.
 */
final class Fragments {
    private static final int MOST_MESSAGES = 4;
    private static final int MOST_PARTS = 100_000;

    private final int mostChars;
    private final Map<String, Parts> incomplete = new LinkedHashMap<>();
    private long chars;

    /** The parts of one message. */
    private static final class Parts {
        private final Map<Integer, String> data = new LinkedHashMap<>();
        private final int total;
        private long chars;

        Parts(int total) {
            this.total = total;
        }

        String joined() {
            StringBuilder text = new StringBuilder();
            for (int i = 0; i < total; i++) {
                text.append(data.get(i));
            }
            return text.toString();
        }
    }

    /**
     * Creates a store.
     *
     * @param mostChars kept of all incomplete messages together
     */
    Fragments(int mostChars) {
        this.mostChars = mostChars;
    }

    /**
     * Adds a fragment.
     *
     * @param fragment the operation; its {@code total} need not be a whole number, and is rounded down
     * @return the text of the message that it completes; null if parts are missing, or the fragment is not valid
     */
    @Nullable
    String add(ObjectNode fragment) {
        int total = (int) Math.floor(fragment.path("total").asDouble(0));
        int number = fragment.path("num").asInt(-1);
        if (total < 1
                || total > MOST_PARTS
                || number < 0
                || number >= total
                || !fragment.path("data").isTextual()) {
            return null;
        }
        String id = fragment.path("id").asText();
        Parts parts = incomplete.get(id);
        if (parts == null || parts.total != total) {
            forget(id);
            parts = new Parts(total);
            incomplete.put(id, parts);
        }
        return keep(id, parts, number, fragment.path("data").textValue());
    }

    private @Nullable String keep(String id, Parts parts, int number, String data) {
        String before = parts.data.put(number, data);
        int more = data.length() - (before == null ? 0 : before.length());
        parts.chars += more;
        chars += more;
        while (!incomplete.isEmpty() && (chars > mostChars || incomplete.size() > MOST_MESSAGES)) {
            forget(incomplete.keySet().iterator().next());
        }
        if (parts.data.size() < parts.total || incomplete.get(id) != parts) {
            return null;
        }
        forget(id);
        return parts.joined();
    }

    private void forget(String id) {
        Parts parts = incomplete.remove(id);
        if (parts != null) {
            chars -= parts.chars;
        }
    }
}
