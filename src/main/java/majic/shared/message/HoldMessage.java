package majic.shared.message;

import com.fasterxml.jackson.databind.node.ObjectNode;

/**
 * The heartbeat of the holder of a robot. Immutable.
 *
 * @param sender the holder
 * @param validUntil until when it counts, ms of the clock of the desk that has the robot
 */
public record HoldMessage(Sender sender, long validUntil) {
    private static final String WHAT = "hold";
    private static final int MOST_BYTES = 4 * 1024;

    /**
     * Writes the message.
     *
     * @return JSON in UTF-8
     */
    public byte[] toJson() {
        ObjectNode json = JsonObject.create();
        sender.write(json);
        return JsonObject.bytes(json.put("validUntil", validUntil));
    }

    /**
     * Reads a message.
     *
     * @param payload JSON in UTF-8
     * @return the heartbeat
     * @throws UnusableMessageException if it is none
     */
    public static HoldMessage parse(byte[] payload) {
        JsonObject json = JsonObject.parse(WHAT, payload, MOST_BYTES);
        return new HoldMessage(Sender.read(json), json.whole("validUntil"));
    }
}
