package majicsim.ros.robot;

import majicsim.ros.graph.RosNetwork;
import majicsim.ros.graph.Topic;
import majicsim.ros.message.RosVersion;
import majicsim.ros.options.RosOptions;
import majicsim.world.Body;
import org.jspecify.annotations.Nullable;

/** The navigation of a robot, in the form of its version of ROS. */
final class Navigation {
    private final GoalDriver navigator;
    private final NavigationFaults faults = new NavigationFaults();
    private final @Nullable MoveBase moveBase;
    private final @Nullable NavigateToPose navigateToPose;

    Navigation(
            RosNetwork network,
            RosOptions options,
            String namespace,
            Topic commands,
            WheelOdometry odometry,
            Body body) {
        boolean isRos1 = options.version() == RosVersion.ROS1;
        commands.addPublisher(namespace + (isRos1 ? "/move_base" : "/controller_server"));
        navigator = new GoalDriver(commands, options, odometry, body::blocked);
        moveBase = isRos1 ? new MoveBase(network, namespace, navigator, faults) : null;
        navigateToPose = isRos1 ? null : new NavigateToPose(network, namespace, navigator, faults);
    }

    NavigationFaults faults() {
        return faults;
    }

    void step(long nowNanos) {
        navigator.step(nowNanos);
        if (moveBase != null) {
            moveBase.step(nowNanos);
        }
        if (navigateToPose != null) {
            navigateToPose.step(nowNanos);
        }
    }

    /** The time of the next step that does anything; never while there is neither goal nor subscriber. */
    long dueNanos() {
        if (navigator.isActive()) {
            return 0;
        }
        return moveBase == null ? Long.MAX_VALUE : moveBase.dueNanos();
    }
}
