package majic.shared.vda5050;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import majic.bot.BotException;
import majic.text.VisibleText;

/**
 * An action that a fleet tool demands at once (VDA 5050, "Topic: instantActions"). Immutable.
 *
 * @param id is repeated in the state of the vehicle
 * @param type what to do
 */
record InstantAction(String id, String type) {
    private static final int MOST_BYTES = 64 * 1024;
    private static final int MOST_ACTIONS = 20;
    private static final int LONGEST = 100;
    private static final int DEEPEST = 20;

    private static final JsonMapper JSON = JsonMapper.builder(JsonFactory.builder()
                    .streamReadConstraints(StreamReadConstraints.builder()
                            .maxNestingDepth(DEEPEST)
                            .build())
                    .build())
            .build();

    /**
     * Reads a message to the topic {@code instantActions}.
     *
     * @throws BotException if it cannot be read, with what is wrong
     */
    static List<InstantAction> parse(byte[] payload) {
        if (payload.length > MOST_BYTES) {
            throw new BotException(payload.length + " bytes are too many; at most " + MOST_BYTES + " are read");
        }
        JsonNode actions = tree(payload).path("actions");
        if (!actions.isArray() || actions.size() > MOST_ACTIONS) {
            throw new BotException("\"actions\" has to be a list of at most " + MOST_ACTIONS + " actions");
        }
        List<InstantAction> all = new ArrayList<>();
        actions.forEach(action -> all.add(new InstantAction(text(action, "actionId"), text(action, "actionType"))));
        return all;
    }

    private static JsonNode tree(byte[] payload) {
        try {
            return JSON.readTree(payload);
        } catch (JsonProcessingException e) {
            throw new BotException("not JSON: " + VisibleText.of(e.getOriginalMessage()), e);
        } catch (IOException e) {
            throw new BotException("not JSON: " + e.getMessage(), e);
        }
    }

    private static String text(JsonNode action, String field) {
        JsonNode node = action.path(field);
        if (!node.isTextual() || node.textValue().isEmpty() || node.textValue().length() > LONGEST) {
            throw new BotException("each action has a \"" + field + "\" of 1 to " + LONGEST + " characters");
        }
        return VisibleText.of(node.textValue());
    }
}
