/**
 * What is there behind a rosbridge server: the version of ROS, topics, nodes, the bases that can be driven, and the
 * table of known robots. Asks through rosapi; publishes and moves nothing.
 */
@NullMarked
package majic.ros.graph;

import org.jspecify.annotations.NullMarked;
