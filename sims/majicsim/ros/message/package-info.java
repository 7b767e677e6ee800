/** ROS messages: their types, and their two JSON forms for ROS 1 and ROS 2. Knows neither topics nor connections. */
@NullMarked
package majicsim.ros.message;

import org.jspecify.annotations.NullMarked;
