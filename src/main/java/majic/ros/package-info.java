/**
 * The driver of robots that speak ROS 1 or ROS 2 through a rosbridge server. Its packages speak the protocol
 * ({@code bridge}, {@code websocket}), find the robots behind a server ({@code graph}), read and make messages
 * ({@code message}) and move a base ({@code motion}).
 */
@NullMarked
package majic.ros;

import org.jspecify.annotations.NullMarked;
