package majicsim.ros.robot;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import majicsim.ros.graph.RosNetwork;
import majicsim.ros.graph.Topic;
import org.jspecify.annotations.Nullable;

/** The node move_base of ROS 1: an action as five topics, and a topic for bare goals (sheet 6). */
final class MoveBase {
    private static final long STATUS_NANOS = 200_000_000;
    private static final int ACTIVE = 1;
    private static final int PREEMPTED = 2;
    private static final int SUCCEEDED = 3;
    private static final int ABORTED = 4;
    private static final int REJECTED = 5;

    private final RosNetwork network;
    private final GoalDriver navigator;
    private final NavigationFaults faults;
    private final Topic status;
    private final Topic feedback;
    private final Topic result;
    private @Nullable ObjectNode goalId;
    private long statusNanos;
    private int count;

    MoveBase(RosNetwork network, String namespace, GoalDriver navigator, NavigationFaults faults) {
        this.network = network;
        this.navigator = navigator;
        this.faults = faults;
        String node = namespace + "/move_base";
        network.nodes().add(node);
        status = network.advertise(node, node + "/status", "actionlib_msgs/GoalStatusArray");
        feedback = network.advertise(node, node + "/feedback", "move_base_msgs/MoveBaseActionFeedback");
        result = network.advertise(node, node + "/result", "move_base_msgs/MoveBaseActionResult");
        network.subscribe(node, node + "/goal", "move_base_msgs/MoveBaseActionGoal", this::goal);
        network.subscribe(node, node + "/cancel", "actionlib_msgs/GoalID", this::cancel);
        network.subscribe(node, namespace + "/move_base_simple/goal", "geometry_msgs/PoseStamped", this::simpleGoal);
    }

    void step(long nowNanos) {
        if (nowNanos >= statusNanos && (goalId != null || status.hasSubscribers())) {
            statusNanos = nowNanos + STATUS_NANOS;
            publishStatus();
        }
    }

    /** The time of the next status; never if nothing receives it. */
    long dueNanos() {
        return status.hasSubscribers() || navigator.isActive() ? statusNanos : Long.MAX_VALUE;
    }

    private void publishStatus() {
        ObjectNode all = stamped();
        all.putArray("status_list");
        if (goalId != null) {
            all.withArray("status_list").add(status(goalId, ACTIVE, ""));
            ObjectNode progress = stamped().set("status", status(goalId, ACTIVE, ""));
            ObjectNode at = Messages.stamped(network.clock().nanos(), "map");
            at.set("pose", Messages.pose(navigator.odometry()));
            progress.putObject("feedback").set("base_position", at);
            feedback.publish(progress);
        }
        status.publish(all);
    }

    private void goal(ObjectNode message) {
        JsonNode given = message.path("goal_id");
        count++;
        String id = given.path("id").asText("");
        ObjectNode ownId = Messages.empty()
                .put("id", id.isEmpty() ? "/move_base-" + count : id)
                .put("stamp", given.path("stamp").asLong());
        if (faults.isRejecting()) {
            end(ownId, REJECTED, "the goal is rejected");
        } else {
            start(ownId, message.path("goal").path("target_pose").path("pose"));
        }
    }

    private void simpleGoal(ObjectNode message) {
        count++;
        start(Messages.empty().put("id", "/move_base-" + count), message.path("pose"));
    }

    private void start(ObjectNode id, JsonNode pose) {
        navigator.start(Goal.of(pose, 0), outcome -> ended(id, outcome));
        goalId = navigator.isActive() ? id : null;
    }

    private void cancel(ObjectNode message) {
        String id = message.path("id").asText("");
        boolean all = id.isEmpty() && message.path("stamp").asLong() == 0;
        if (goalId != null && (all || goalId.path("id").asText().equals(id))) {
            navigator.cancel();
        }
    }

    private void ended(ObjectNode id, GoalDriver.Outcome outcome) {
        goalId = null;
        switch (outcome) {
            case REACHED -> end(id, SUCCEEDED, "Goal reached.");
            case FAILED -> end(id, ABORTED, "Failed to find a valid control.");
            case CANCELED, REPLACED -> end(id, PREEMPTED, "");
        }
    }

    private void end(ObjectNode id, int code, String text) {
        result.publish(stamped().set("status", status(id, code, text)));
    }

    private ObjectNode stamped() {
        return Messages.stamped(network.clock().nanos(), "");
    }

    private static ObjectNode status(ObjectNode id, int code, String text) {
        ObjectNode status = Messages.empty().put("status", code).put("text", text);
        return status.set("goal_id", id);
    }
}
