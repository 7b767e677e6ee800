package majic.shared.message;

import com.fasterxml.jackson.databind.node.ObjectNode;

/**
 * A drive for the next 600 ms. Immutable.
 *
 * @param sender the program that drives the robot
 * @param number counts with the requests of the session, so that a stop can void it; 0 if it has none
 * @param mmPerSec ahead positive
 * @param degPerSec counterclockwise positive
 * @param validUntil until when it may be accepted, ms of the clock of the desk that has the robot
 */
public record SpeedMessage(Sender sender, long number, double mmPerSec, double degPerSec, long validUntil) {
    private static final String WHAT = "speed";
    private static final int MOST_BYTES = 4 * 1024;

    /**
     * Writes the message.
     *
     * @return JSON in UTF-8
     */
    public byte[] toJson() {
        ObjectNode json = JsonObject.create();
        sender.write(json);
        json.put("number", number).put("mmPerSec", mmPerSec).put("degPerSec", degPerSec);
        return JsonObject.bytes(json.put("validUntil", validUntil));
    }

    /**
     * Reads a message.
     *
     * @param payload JSON in UTF-8
     * @return the speed
     * @throws UnusableMessageException if it is none
     */
    public static SpeedMessage parse(byte[] payload) {
        JsonObject json = JsonObject.parse(WHAT, payload, MOST_BYTES);
        return new SpeedMessage(
                Sender.read(json),
                json.whole("number", 0),
                json.number("mmPerSec"),
                json.number("degPerSec", 0),
                json.whole("validUntil"));
    }
}
