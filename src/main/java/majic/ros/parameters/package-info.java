/**
 * The parameters and extra commands of a ROS robot, grouped by theme. Units are mm, degrees and seconds; only the
 * fields of topics that are named by their own names stay as the robot sends them.
 */
@NullMarked
package majic.ros.parameters;

import org.jspecify.annotations.NullMarked;
