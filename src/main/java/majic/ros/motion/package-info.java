/**
 * Motions of a ROS base: velocities with limited acceleration, repeated as long as the base moves; motions closed by
 * odometry; stops, repeated until the odometry shows the base stationary. Uses no connection and no message, only
 * {@link majic.ros.motion.VelocityOutput} and the readings passed to {@link majic.ros.motion.RosMotion}.
 */
@NullMarked
package majic.ros.motion;

import org.jspecify.annotations.NullMarked;
