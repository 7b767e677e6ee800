/** The services of the node rosapi, by which clients find out what a ROS network has (sheet 5). */
@NullMarked
package majicsim.ros.rosapi;

import org.jspecify.annotations.NullMarked;
