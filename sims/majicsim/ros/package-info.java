/**
 * The simulated ROS robot: a TurtleBot3 behind a rosbridge server, in the dialects of ROS 1 and ROS 2. "Sheet" in its
 * comments is the project's collection of facts on rosbridge v2, from its sources and a captured session.
 */
@NullMarked
package majicsim.ros;

import org.jspecify.annotations.NullMarked;
