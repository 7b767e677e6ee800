package majic.shared.message;

import com.fasterxml.jackson.databind.node.ObjectNode;

/**
 * A stop of one robot. Immutable.
 *
 * @param sender the program that stops the robot; need not hold it
 * @param after the number of the last request of the sender: all up to it that have not begun are void
 * @param id random, the same in both copies of one stop; empty if it has none
 */
public record StopMessage(Sender sender, long after, String id) {
    private static final String WHAT = "stop";
    private static final int MOST_BYTES = 4 * 1024;

    /**
     * Writes the message.
     *
     * @return JSON in UTF-8
     */
    public byte[] toJson() {
        ObjectNode json = JsonObject.create();
        sender.write(json);
        return JsonObject.bytes(json.put("after", after).put("id", id));
    }

    /**
     * Reads a message.
     *
     * @param payload JSON in UTF-8
     * @return the stop
     * @throws UnusableMessageException if it is none
     */
    public static StopMessage parse(byte[] payload) {
        JsonObject json = JsonObject.parse(WHAT, payload, MOST_BYTES);
        return new StopMessage(Sender.read(json), json.whole("after", 0), json.text("id", ""));
    }
}
