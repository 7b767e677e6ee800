package majicsim.ros.bridge;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Finds JSON in what a client sends, as the bridge does (sheet 2, framing errors): text that cannot be parsed is put
 * before the next message, and the first object with an {@code op} in it is taken wherever it begins.
 */
final class InputBuffer {
    /** Each opening brace is tried, which is quadratic; the real bridge has no limit and becomes slow. */
    private static final int MOST_KEPT = 100_000;

    private final ObjectMapper mapper;
    private String kept = "";

    InputBuffer(ObjectMapper mapper) {
        this.mapper = mapper;
    }

    /** Returns the values in a message, in order. */
    List<JsonNode> take(String message) {
        kept += message;
        List<JsonNode> values = new ArrayList<>();
        for (JsonNode value = next(); value != null; value = kept.isEmpty() ? null : next()) {
            values.add(value);
        }
        if (kept.length() > MOST_KEPT) {
            kept = "";
        }
        return values;
    }

    private @Nullable JsonNode next() {
        try {
            JsonNode whole = mapper.readTree(kept);
            if (!whole.isMissingNode() && !hasMore(kept)) {
                kept = "";
                return whole;
            }
        } catch (JsonProcessingException e) {
            // Not one JSON value; it may contain some.
        }
        return search();
    }

    /** Whether there is anything behind the first value. */
    private boolean hasMore(String text) throws JsonProcessingException {
        try (JsonParser parser = mapper.createParser(text)) {
            parser.nextToken();
            parser.skipChildren();
            return parser.nextToken() != null;
        } catch (JsonProcessingException e) {
            throw e;
        } catch (IOException e) {
            throw new UncheckedIOException("cannot read from memory", e);
        }
    }

    private @Nullable JsonNode search() {
        for (int start = kept.indexOf('{'); start >= 0; start = kept.indexOf('{', start + 1)) {
            try (JsonParser parser = mapper.createParser(kept.substring(start))) {
                JsonNode found = mapper.readTree(parser);
                if (found != null && found.has("op")) {
                    kept = kept.substring(start + (int) parser.currentLocation().getCharOffset());
                    return found;
                }
            } catch (JsonProcessingException e) {
                // Nothing complete begins here; the next brace may be the right one.
            } catch (IOException e) {
                throw new UncheckedIOException("cannot read from memory", e);
            }
        }
        return null;
    }
}
