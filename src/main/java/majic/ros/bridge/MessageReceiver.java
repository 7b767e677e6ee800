package majic.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;

/** Handles the messages of a topic. Called on the reader thread, which must not wait; what it throws is logged. */
@FunctionalInterface
public interface MessageReceiver {
    /**
     * Handles a message.
     *
     * @param message its content
     * @param bytes the length of the operation that it came with
     */
    void message(JsonNode message, int bytes);
}
