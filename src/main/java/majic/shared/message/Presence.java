package majic.shared.message;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Locale;

/**
 * Whether a desk shares its robots at the moment. Immutable.
 *
 * @param state what it does
 * @param sender the desk, its person, its session
 * @param program name and version of the program
 * @param robots the numbers of the robots that it shares
 */
public record Presence(State state, Sender sender, String program, List<Integer> robots) {
    private static final String WHAT = "presence";
    private static final int MOST_BYTES = 64 * 1024;

    /** What a desk does. */
    public enum State {
        /** It shares its robots. */
        ONLINE,
        /** It has ended. */
        OFFLINE,
        /** The broker lost its connection: the last will. */
        BROKEN
    }

    /** Keeps a copy of the list. */
    public Presence {
        robots = List.copyOf(robots);
    }

    /**
     * Returns the same desk in another state, without robots.
     *
     * @param other the state
     * @return the presence
     */
    public Presence ended(State other) {
        return new Presence(other, sender, program, List.of());
    }

    /**
     * Writes the message.
     *
     * @return JSON in UTF-8
     */
    public byte[] toJson() {
        ObjectNode json = JsonObject.create().put("state", state.name().toLowerCase(Locale.ROOT));
        sender.write(json);
        json.put("program", program);
        ArrayNode numbers = json.putArray("robots");
        robots.forEach(numbers::add);
        return JsonObject.bytes(json);
    }

    /**
     * Reads a message. A state that this version does not know counts as broken.
     *
     * @param payload JSON in UTF-8
     * @return the presence
     * @throws UnusableMessageException if it is none
     */
    public static Presence parse(byte[] payload) {
        JsonObject json = JsonObject.parse(WHAT, payload, MOST_BYTES);
        return new Presence(
                state(json.text("state")),
                Sender.read(json),
                json.text("program", ""),
                json.list("robots", node -> node.asInt(0)));
    }

    private static State state(String word) {
        return switch (word) {
            case "online" -> State.ONLINE;
            case "offline" -> State.OFFLINE;
            default -> State.BROKEN;
        };
    }
}
