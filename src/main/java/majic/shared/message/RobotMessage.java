package majic.shared.message;

import java.util.Locale;

/**
 * A line about a robot for users. Immutable.
 *
 * @param kind what kind of line it is
 * @param text one line, without the robot's number
 */
public record RobotMessage(Kind kind, String text) {
    private static final String WHAT = "message";
    private static final int MOST_BYTES = 64 * 1024;

    /** What kinds of lines there are. */
    public enum Kind {
        /** A message of the robot or of the program on its behalf. */
        MESSAGE,
        /** How a command ended. */
        ANSWER,
        /** A lost connection, or a stop that was not confirmed. */
        ALARM
    }

    /**
     * Writes the message.
     *
     * @return JSON in UTF-8
     */
    public byte[] toJson() {
        return JsonObject.bytes(JsonObject.create()
                .put("kind", kind.name().toLowerCase(Locale.ROOT))
                .put("text", text));
    }

    /**
     * Reads a message. A kind that this version does not know is a message.
     *
     * @param payload JSON in UTF-8
     * @return the line
     * @throws UnusableMessageException if it is none
     */
    public static RobotMessage parse(byte[] payload) {
        JsonObject json = JsonObject.parse(WHAT, payload, MOST_BYTES);
        return new RobotMessage(kind(json.text("kind", "")), json.text("text"));
    }

    private static Kind kind(String word) {
        return switch (word) {
            case "answer" -> Kind.ANSWER;
            case "alarm" -> Kind.ALARM;
            default -> Kind.MESSAGE;
        };
    }
}
