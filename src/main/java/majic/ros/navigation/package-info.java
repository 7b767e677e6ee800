/**
 * Goals that the robot pursues by itself: places to drive to with move_base (ROS 1) or Nav2 (ROS 2), and the dock of a
 * Create 3. A goal is a motion: it needs the robot to be free, and a stop cancels it.
 */
@NullMarked
package majic.ros.navigation;

import org.jspecify.annotations.NullMarked;
