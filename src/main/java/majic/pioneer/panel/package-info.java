/**
 * The panel that shows one Pioneer: a map with sonar cones and echoes, gauges, lights and readings. It sends nothing to
 * the robot.
 */
@NullMarked
package majic.pioneer.panel;

import org.jspecify.annotations.NullMarked;
