/**
 * The server's end of a WebSocket connection (RFC 6455): handshake, frames, messages, pings, closing. Knows nothing of
 * ROS.
 */
@NullMarked
package majicsim.ros.websocket;

import org.jspecify.annotations.NullMarked;
