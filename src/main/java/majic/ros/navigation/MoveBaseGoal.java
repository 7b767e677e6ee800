package majic.ros.navigation;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.UUID;
import java.util.function.Consumer;
import majic.ros.bridge.TopicSubscription;
import majic.ros.readings.RosClient;
import majic.time.Signal;

/** A goal of move_base on ROS 1, where an action is five topics (rosbridge sheet 6). */
final class MoveBaseGoal extends Goal {
    /** Numbers of actionlib_msgs/GoalStatus: the goal is preempted, or was recalled before it began. */
    private static final List<Integer> CANCELLED = List.of(2, 8);

    private static final int SUCCEEDED = 3;

    private final RosClient connection;
    private final String server;
    private final ObjectNode targetPose;
    private final String id = "majic-" + UUID.randomUUID();
    private final List<Runnable> subscriptions;

    /**
     * A goal that is not sent yet; subscribes to its result.
     *
     * @param server the beginning of the names of its topics
     * @param targetPose a {@code geometry_msgs/PoseStamped}
     * @param changes raised after each event
     */
    MoveBaseGoal(RosClient connection, String server, ObjectNode targetPose, Signal changes) {
        super(changes);
        this.connection = connection;
        this.server = server;
        this.targetPose = targetPose;
        this.subscriptions = List.of(
                subscribe("/status", "actionlib_msgs/GoalStatusArray", this::listed),
                subscribe("/result", "move_base_msgs/MoveBaseActionResult", this::ended));
    }

    private Runnable subscribe(String topic, String type, Consumer<JsonNode> onMessage) {
        return connection.subscribe(new TopicSubscription(server + topic, type, 0, 10, false), onMessage);
    }

    @Override
    void send() {
        ObjectNode message = JsonNodeFactory.instance.objectNode();
        message.putObject("header");
        message.putObject("goal_id").put("id", id);
        message.putObject("goal").set("target_pose", targetPose);
        connection.publish(server + "/goal", "move_base_msgs/MoveBaseActionGoal", message);
    }

    @Override
    void sendCancel() {
        cancelAll(connection, server);
    }

    /**
     * Cancels the goals of all programs, since the robot is to stop: an empty id and no stamp mean all of them.
     *
     * @param server the beginning of the names of the topics
     */
    static void cancelAll(RosClient connection, String server) {
        connection.publish(
                server + "/cancel",
                "actionlib_msgs/GoalID",
                JsonNodeFactory.instance.objectNode().put("id", ""));
    }

    private void listed(JsonNode message) {
        for (JsonNode status : message.path("status_list")) {
            if (isOwn(status)) {
                reported();
            }
        }
    }

    private void ended(JsonNode message) {
        JsonNode status = message.path("status");
        if (isOwn(status)) {
            int number = status.path("status").asInt();
            Result how = number == SUCCEEDED
                    ? Result.SUCCEEDED
                    : CANCELLED.contains(number) ? Result.CANCELLED : Result.FAILED;
            end(how, status.path("text").asText(""));
        }
    }

    private boolean isOwn(JsonNode status) {
        return status.path("goal_id").path("id").asText().equals(id);
    }

    @Override
    public void close() {
        subscriptions.forEach(Runnable::run);
    }
}
