package majicsim.ros.graph;

import com.fasterxml.jackson.databind.node.ObjectNode;
import majicsim.ros.message.MessageType;

/**
 * One service.
 *
 * @param name absolute
 * @param node that offers it
 * @param typeName full name of its type
 * @param request type of what it takes
 * @param response type of what it returns
 * @param handler carries it out
 */
public record Service(
        String name, String node, String typeName, MessageType request, MessageType response, Handler handler) {
    /** Carries a service out. */
    public interface Handler {
        /**
         * Carries it out, now or later.
         *
         * @param request checked; missing fields mean zero
         * @param reply receives the outcome
         */
        void call(ObjectNode request, ServiceReply reply);
    }
}
