package majicsim.ros.graph;

import com.fasterxml.jackson.databind.node.ObjectNode;

/** Receives the messages of a topic. */
public interface TopicListener {
    /**
     * Reports a message.
     *
     * @param message checked or made by the robot; not changed afterwards
     */
    void published(ObjectNode message);
}
