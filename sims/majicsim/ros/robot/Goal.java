package majicsim.ros.robot;

import com.fasterxml.jackson.databind.JsonNode;

/**
 * A place to drive to, in the frame of the map, which is that of the odometry.
 *
 * @param x m
 * @param y m
 * @param yaw rad counter-clockwise
 */
record Goal(double x, double y, double yaw) {
    private static final double LEAST_LENGTH = 0.1;

    /**
     * Reads a geometry_msgs/Pose; an orientation that is no rotation gives a goal that is not valid. A missing w is
     * {@code usualW}: 0 on ROS 1, 1 on ROS 2.
     */
    static Goal of(JsonNode pose, double usualW) {
        JsonNode position = pose.path("position");
        JsonNode rotation = pose.path("orientation");
        double x = rotation.path("x").asDouble();
        double y = rotation.path("y").asDouble();
        double z = rotation.path("z").asDouble();
        double w = rotation.path("w").asDouble(usualW);
        double length = Math.sqrt(x * x + y * y + z * z + w * w);
        double yaw = length < LEAST_LENGTH ? Double.NaN : Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
        return new Goal(position.path("x").asDouble(), position.path("y").asDouble(), yaw);
    }

    boolean isValid() {
        return Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(yaw);
    }
}
