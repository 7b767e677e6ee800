package majicsim.ros.graph;

import com.fasterxml.jackson.databind.node.ObjectNode;

/** Receives what becomes of one goal. */
public interface GoalListener {
    /** Status of a goal that was reached ({@code action_msgs/GoalStatus}). */
    int SUCCEEDED = 4;

    /** Status of a goal that was cancelled. */
    int CANCELED = 5;

    /** Status of a goal that was given up. */
    int ABORTED = 6;

    /**
     * Reports progress.
     *
     * @param feedback of the action's type
     */
    void progress(ObjectNode feedback);

    /**
     * Reports the end, once.
     *
     * @param status one of the constants
     * @param result of the action's type
     */
    void ended(int status, ObjectNode result);
}
