/** The ROS network of one simulated computer: nodes, topics, services, actions, parameters, and its clock. */
@NullMarked
package majicsim.ros.graph;

import org.jspecify.annotations.NullMarked;
