/** What kind of ROS robot and bridge is simulated. */
@NullMarked
package majicsim.ros.options;

import org.jspecify.annotations.NullMarked;
