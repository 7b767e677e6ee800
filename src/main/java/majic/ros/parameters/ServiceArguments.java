package majic.ros.parameters;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.BotException;

/**
 * The arguments of a service as users type them: JSON, in which names need no quotes and single quotes may replace
 * double ones, or pairs such as {@code x=1 pose.y=2 name=bob}.
 */
final class ServiceArguments {
    private static final JsonMapper LENIENT = JsonMapper.builder()
            .enable(JsonReadFeature.ALLOW_SINGLE_QUOTES, JsonReadFeature.ALLOW_UNQUOTED_FIELD_NAMES)
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .build();

    private static final Pattern PAIR =
            Pattern.compile("\\s*([\\w.]+)=('[^']*'|\\[[^\\]]*\\]|\\{.*\\}|[^\\s,]+)[\\s,]*");

    private ServiceArguments() {}

    /**
     * Reads the arguments.
     *
     * @param texts as typed; pairs may be spread over them
     * @return an object, empty without any text
     * @throws BotException if they are neither JSON nor pairs; the message shows the form
     */
    static ObjectNode parse(List<String> texts) {
        String text = String.join(" ", texts).strip();
        return text.startsWith("{") ? object(text) : pairs(text);
    }

    private static ObjectNode object(String text) {
        try {
            if (LENIENT.readTree(text) instanceof ObjectNode object) {
                return object;
            }
        } catch (JsonProcessingException e) {
            throw new BotException(text + ": is not JSON: " + e.getOriginalMessage(), e);
        }
        throw new BotException(text + ": the arguments have to be one object, as in \"{x: 1, name: 'bob'}\"");
    }

    private static ObjectNode pairs(String text) {
        ObjectNode object = JsonNodeFactory.instance.objectNode();
        Matcher pair = PAIR.matcher(text);
        int at = 0;
        while (at < text.length()) {
            if (!pair.region(at, text.length()).lookingAt()) {
                throw new BotException(
                        text.substring(at) + ": is no argument; write them as in \"x=1 name=bob\" or \"{x: 1}\"");
            }
            put(object, pair.group(1), value(pair.group(2)));
            at = pair.end();
        }
        return object;
    }

    /** A point leads into an inner object. */
    private static void put(ObjectNode object, String path, JsonNode value) {
        ObjectNode inner = object;
        String[] names = path.split("\\.");
        for (int index = 0; index < names.length - 1; index++) {
            inner = inner.get(names[index]) instanceof ObjectNode known ? known : inner.putObject(names[index]);
        }
        inner.set(names[names.length - 1], value);
    }

    /** What is no JSON is a text. */
    private static JsonNode value(String text) {
        try {
            return LENIENT.readTree(text);
        } catch (JsonProcessingException e) {
            return JsonNodeFactory.instance.textNode(text);
        }
    }
}
