/**
 * What robots measure of their surroundings: range sensors and their beams, scans, and odometry. Distances are in mm
 * and angles in degrees, counterclockwise positive, in the robot's frame with x ahead and y to the left.
 */
@NullMarked
package majic.nav.range;

import org.jspecify.annotations.NullMarked;
