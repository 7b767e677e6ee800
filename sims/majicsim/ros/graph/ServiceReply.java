package majicsim.ros.graph;

import com.fasterxml.jackson.databind.node.ObjectNode;

/** Where the outcome of one call of a service goes, at once or later. Exactly one method is called, once. */
public interface ServiceReply {
    /**
     * The service was carried out.
     *
     * @param response checked or made by the robot
     */
    void succeed(ObjectNode response);

    /**
     * The service failed.
     *
     * @param reason as the caller receives it
     */
    void fail(String reason);
}
