package majic.shared.message;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.OptionalLong;

/**
 * A request to a shared robot. Immutable.
 *
 * @param sender the program that receives the answer
 * @param number counts the requests of the session, from 1 on; the same number is not executed twice
 * @param validUntil until when it may be accepted, ms of the clock of the desk that has the robot; empty for a request
 *     without a limit, which only some may be
 * @param action what to do
 */
public record Request(Sender sender, long number, OptionalLong validUntil, RequestedAction action) {
    /** A longer request is refused. */
    public static final int MOST_BYTES = 64 * 1024;

    private static final String WHAT = "request";

    /**
     * Writes the message.
     *
     * @return JSON in UTF-8
     */
    public byte[] toJson() {
        ObjectNode json = JsonObject.create();
        sender.write(json);
        json.put("number", number);
        validUntil.ifPresent(ms -> json.put("validUntil", ms));
        RequestedAction.write(action, json);
        return JsonObject.bytes(json);
    }

    /**
     * Reads a message.
     *
     * @param payload JSON in UTF-8
     * @return the request
     * @throws UnusableMessageException if it is none
     */
    public static Request parse(byte[] payload) {
        JsonObject json = JsonObject.parse(WHAT, payload, MOST_BYTES);
        long number = json.whole("number");
        if (number < 1) {
            throw json.wrong("number", "it counts the requests of the session from 1 on");
        }
        OptionalLong valid = json.has("validUntil") ? OptionalLong.of(json.whole("validUntil")) : OptionalLong.empty();
        return new Request(Sender.read(json), number, valid, RequestedAction.read(json));
    }
}
