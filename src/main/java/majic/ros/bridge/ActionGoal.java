package majic.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import majic.bot.BotException;

/**
 * The goal of an action of ROS 2. Immutable.
 *
 * @param action the absolute name of the action, as {@code /navigate_to_pose}
 * @param type as {@code nav2_msgs/action/NavigateToPose}
 * @param arguments the goal by the names of its fields
 */
public record ActionGoal(String action, String type, JsonNode arguments) {
    /** Handles what becomes of a goal. Called on the reader thread, which must not wait. */
    public interface Events {
        /**
         * Handles a report of progress.
         *
         * @param values by the names of their fields
         */
        void feedback(JsonNode values);

        /**
         * Handles the result, the last event of a goal.
         *
         * @param status 4 succeeded, 5 cancelled, 6 aborted, 0 unknown (action_msgs/GoalStatus)
         * @param values the result by the names of its fields, or a text with the reason of a failure
         */
        void result(int status, JsonNode values);

        /**
         * Handles the end of the connection before the result; the goal may still be pursued.
         *
         * @param cause why
         */
        void failed(BotException cause);
    }
}
