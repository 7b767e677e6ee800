/**
 * The panel that shows one ROS robot: a map with its scan, echoes and path, the picture of its camera, gauges, lights
 * and the topics with their ages. It gets what it shows as one record, and sends nothing to the robot.
 */
@NullMarked
package majic.ros.panel;

import org.jspecify.annotations.NullMarked;
