/**
 * What a ROS robot reports beside its odometry: which sensors it has, their newest messages, and the distances that
 * follow from them. All ages count from the arrival of a message: the stamps in messages are of the robot's clock,
 * which may jump. The package commands nothing.
 */
@NullMarked
package majic.ros.readings;

import org.jspecify.annotations.NullMarked;
