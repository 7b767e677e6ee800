package majicsim.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import majicsim.ros.message.JsonForm;
import org.jspecify.annotations.Nullable;

/** One client, as the operations use it. */
interface Peer {
    /** The name of the bridge's node, for all its clients. */
    String NODE = "/rosbridge_websocket";

    /**
     * Sends one object, in fragments if the client asked for these; {@code id} is that of the message, for its
     * fragments.
     */
    void send(@Nullable JsonNode id, JsonForm.Content content);

    /** Sends one binary message. */
    void sendBinary(byte[] payload);

    /** Sets the length from which messages to this client are divided; 0 for never. */
    void fragmentSize(int characters);

    /** Holds up what the client sends later, or goes on; the calls are counted. */
    void hold(boolean begins);

    /** Takes a message as if it had just arrived. */
    void arrived(String text);

    /** Whether the client leaves unread what it was sent. */
    boolean isSlow();
}
