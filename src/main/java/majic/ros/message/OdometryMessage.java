package majic.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import majic.bot.Pose;

/**
 * Where a base counts itself, and how fast it moves ({@code nav_msgs/Odometry}). Immutable. The pose does not start at
 * zero, and it may jump when the base is reset. The stamp is left out on purpose: it is the robot's clock, which may
 * jump; what is measured in time uses the arrival.
 *
 * @param pose in the frame {@code frame}
 * @param speedMmPerSec in the robot's own axes, ahead positive
 * @param turnRateDegPerSec counterclockwise positive
 * @param frame the frame of the pose, usually {@code odom}; empty if the message names none
 * @param base the frame of the robot, usually {@code base_link} or {@code base_footprint}; empty if the message names
 *     none
 */
public record OdometryMessage(Pose pose, double speedMmPerSec, double turnRateDegPerSec, String frame, String base) {

    /**
     * Reads a message.
     *
     * @param message the content of a {@code nav_msgs/Odometry}
     * @return the odometry
     * @throws UnusableMessage if the pose or the velocity is not given in finite numbers
     */
    public static OdometryMessage from(JsonNode message) {
        Pose pose = new Pose(
                RosUnits.mm(Fields.number(message, "pose.pose.position.x")),
                RosUnits.mm(Fields.number(message, "pose.pose.position.y")),
                Orientation.from(message, "pose.pose.orientation").yawDeg());
        return new OdometryMessage(
                pose,
                RosUnits.mm(Fields.number(message, "twist.twist.linear.x")),
                Math.toDegrees(Fields.number(message, "twist.twist.angular.z")),
                Fields.frame(message, "header.frame_id"),
                Fields.frame(message, "child_frame_id"));
    }
}
