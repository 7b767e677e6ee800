package majic.ros.navigation;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.OptionalDouble;
import majic.bot.BotException;
import majic.ros.bridge.ActionGoal;
import majic.ros.readings.RosClient.GoalChannel;
import majic.time.Signal;

/** A goal of an action of ROS 2. */
final class ActionGoalRun extends Goal implements ActionGoal.Events {
    /** Numbers of action_msgs/GoalStatus. */
    private static final int SUCCEEDED = 4;

    private static final int CANCELLED = 5;
    private static final double MM_PER_M = 1000;

    private final GoalChannel channel;
    private final ActionGoal goal;
    private volatile OptionalDouble leftMm = OptionalDouble.empty();

    /**
     * A goal that is not sent yet.
     *
     * @param channel closed with this goal
     * @param changes raised after each event
     */
    ActionGoalRun(GoalChannel channel, ActionGoal goal, Signal changes) {
        super(changes);
        this.channel = channel;
        this.goal = goal;
    }

    @Override
    void send() {
        channel.send(goal, this);
    }

    @Override
    void sendCancel() {
        channel.cancel();
    }

    @Override
    OptionalDouble leftMm() {
        return leftMm;
    }

    @Override
    public void feedback(JsonNode values) {
        JsonNode left = values.path("distance_remaining");
        if (left.isNumber() && Double.isFinite(left.doubleValue())) {
            leftMm = OptionalDouble.of(left.doubleValue() * MM_PER_M);
        }
        reported();
    }

    @Override
    public void result(int status, JsonNode values) {
        String why = values.isTextual()
                ? values.asText()
                : values.path("error_msg").asText(values.path("error_code").asText(""));
        end(status == SUCCEEDED ? Result.SUCCEEDED : status == CANCELLED ? Result.CANCELLED : Result.FAILED, why);
    }

    @Override
    public void failed(BotException cause) {
        end(Result.FAILED, String.valueOf(cause.getMessage()));
    }

    @Override
    public void close() {
        channel.close();
    }
}
