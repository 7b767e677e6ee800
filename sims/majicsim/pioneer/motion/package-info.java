/** Drive motors, speed ramps, heading servo, stall detection and odometry. */
@NullMarked
package majicsim.pioneer.motion;

import org.jspecify.annotations.NullMarked;
