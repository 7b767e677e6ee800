package majicsim.ros.robot;

import com.fasterxml.jackson.databind.node.ObjectNode;
import majicsim.ros.graph.ActionServer;
import majicsim.ros.graph.GoalListener;
import majicsim.ros.graph.RosNetwork;
import majicsim.ros.graph.ServiceReply;
import majicsim.ros.message.MessageType;
import org.jspecify.annotations.Nullable;

/** The action navigate_to_pose of ROS 2, its service that cancels, and the topic for bare goals (sheet 6). */
final class NavigateToPose implements ActionServer {
    private static final long FEEDBACK_NANOS = 200_000_000;

    private final RosNetwork network;
    private final String name;
    private final GoalDriver navigator;
    private final NavigationFaults faults;
    private @Nullable GoalListener client;
    private long feedbackNanos;

    NavigateToPose(RosNetwork network, String namespace, GoalDriver navigator, NavigationFaults faults) {
        this.network = network;
        this.navigator = navigator;
        this.faults = faults;
        this.name = namespace + "/navigate_to_pose";
        String node = namespace + "/bt_navigator";
        network.nodes().add(node);
        network.actions().put(name, this);
        network.offer(node, name + "/_action/cancel_goal", "action_msgs/CancelGoal", this::cancelAll);
        network.subscribe(node, namespace + "/goal_pose", "geometry_msgs/PoseStamped", this::bareGoal);
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public String typeName() {
        return "nav2_msgs/action/NavigateToPose";
    }

    @Override
    public MessageType goalType() {
        return network.types().get("nav2_msgs/NavigateToPoseGoal");
    }

    @Override
    public MessageType feedbackType() {
        return network.types().get("nav2_msgs/NavigateToPoseFeedback");
    }

    @Override
    public MessageType resultType() {
        return network.types().get("nav2_msgs/NavigateToPoseResult");
    }

    @Override
    public void start(ObjectNode goal, GoalListener listener) {
        if (faults.isRejecting()) {
            return;
        }
        navigator.start(Goal.of(goal.path("pose").path("pose"), 1), outcome -> {
            client = null;
            listener.ended(status(outcome), Messages.empty());
        });
        client = navigator.isActive() ? listener : null;
    }

    @Override
    public void cancel(GoalListener listener) {
        if (listener.equals(client)) {
            navigator.cancel();
        }
    }

    void step(long nowNanos) {
        if (client != null && nowNanos >= feedbackNanos) {
            feedbackNanos = nowNanos + FEEDBACK_NANOS;
            ObjectNode feedback = Messages.empty().put("distance_remaining", navigator.remaining());
            ObjectNode at = Messages.stamped(network.clock().nanos(), "map");
            feedback.set("current_pose", at.set("pose", Messages.pose(navigator.odometry())));
            client.progress(feedback);
        }
    }

    private void bareGoal(ObjectNode message) {
        navigator.start(Goal.of(message.path("pose"), 1), outcome -> {});
    }

    private void cancelAll(ObjectNode request, ServiceReply reply) {
        navigator.cancel();
        reply.succeed(Messages.empty());
    }

    private static int status(GoalDriver.Outcome outcome) {
        return switch (outcome) {
            case REACHED -> GoalListener.SUCCEEDED;
            case CANCELED -> GoalListener.CANCELED;
            case FAILED, REPLACED -> GoalListener.ABORTED;
        };
    }
}
