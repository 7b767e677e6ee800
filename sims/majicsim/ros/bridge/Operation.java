package majicsim.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import majicsim.ros.message.MessageMismatch;

/** One operation of the protocol. */
interface Operation {
    /**
     * Carries it out.
     *
     * @param message the received object
     * @throws MessageMismatch if it is dropped; the client is not told (sheet 1, rule 1)
     */
    void carryOut(JsonNode message) throws MessageMismatch;
}
