/** The TurtleBot3 behind the bridge: wheels, odometry, sensors, navigation, and the topics that they have. */
@NullMarked
package majicsim.ros.robot;

import org.jspecify.annotations.NullMarked;
