package majicsim.ros.graph;

import com.fasterxml.jackson.databind.node.ObjectNode;
import majicsim.ros.message.MessageType;

/** An action of ROS 2. Guarded by the lab's lock. */
public interface ActionServer {
    /**
     * Its name.
     *
     * @return absolute
     */
    String name();

    /**
     * Its type.
     *
     * @return full name
     */
    String typeName();

    /**
     * The type of its goals.
     *
     * @return as a message type
     */
    MessageType goalType();

    /**
     * The type of its feedback.
     *
     * @return as a message type
     */
    MessageType feedbackType();

    /**
     * The type of its results.
     *
     * @return as a message type
     */
    MessageType resultType();

    /**
     * Starts a goal.
     *
     * @param goal checked
     * @param listener receives feedback and result; nothing at all if the goal is rejected
     */
    void start(ObjectNode goal, GoalListener listener);

    /**
     * Cancels a goal; without effect if it has ended.
     *
     * @param listener with which it was started
     */
    void cancel(GoalListener listener);
}
