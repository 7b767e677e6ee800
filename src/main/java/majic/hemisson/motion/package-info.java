/**
 * A Hemisson's motions, which are timed because the robot measures none of them: speeds, dead reckoning, calibration,
 * and the monitor that stops a robot that does not answer or obey.
 */
@NullMarked
package majic.hemisson.motion;

import org.jspecify.annotations.NullMarked;
