package majic.ros.navigation;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicBoolean;
import majic.bot.BotException;
import majic.ros.bridge.ActionGoal;
import majic.ros.readings.RosClient.GoalChannel;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/** A goal of an action of ROS 2. */
final class ActionGoalRun implements Goal, ActionGoal.Events {
    /** Numbers of action_msgs/GoalStatus. */
    private static final int SUCCEEDED = 4;

    private static final int CANCELLED = 5;
    private static final double MM_PER_M = 1000;

    private final GoalChannel channel;
    private final ActionGoal goal;
    private final Signal changes;
    private final AtomicBoolean cancelled = new AtomicBoolean();
    private volatile boolean answered;
    private volatile @Nullable Result result;
    private volatile String reason = "";
    private volatile OptionalDouble leftMm = OptionalDouble.empty();

    /**
     * A goal that is not sent yet.
     *
     * @param channel closed with this goal
     * @param changes raised after each event
     */
    ActionGoalRun(GoalChannel channel, ActionGoal goal, Signal changes) {
        this.channel = channel;
        this.goal = goal;
        this.changes = changes;
    }

    @Override
    public void send() {
        channel.send(goal, this);
    }

    @Override
    public void cancel() {
        if (!cancelled.getAndSet(true)) {
            channel.cancel();
        }
    }

    @Override
    public boolean isAnswered() {
        return answered;
    }

    @Override
    public Optional<Result> result() {
        return Optional.ofNullable(result);
    }

    @Override
    public String reason() {
        return reason;
    }

    @Override
    public OptionalDouble leftMm() {
        return leftMm;
    }

    @Override
    public void feedback(JsonNode values) {
        JsonNode left = values.path("distance_remaining");
        if (left.isNumber() && Double.isFinite(left.doubleValue())) {
            leftMm = OptionalDouble.of(left.doubleValue() * MM_PER_M);
        }
        answered = true;
        changes.raise();
    }

    @Override
    public void result(int status, JsonNode values) {
        reason = values.isTextual()
                ? values.asText()
                : values.path("error_msg").asText(values.path("error_code").asText(""));
        end(status == SUCCEEDED ? Result.SUCCEEDED : status == CANCELLED ? Result.CANCELLED : Result.FAILED);
    }

    @Override
    public void failed(BotException cause) {
        reason = String.valueOf(cause.getMessage());
        end(Result.FAILED);
    }

    private void end(Result how) {
        answered = true;
        result = how;
        changes.raise();
    }

    @Override
    public void close() {
        channel.close();
    }
}
