/**
 * A WebSocket client (RFC 6455) over a {@link majic.link.Link}: handshake, frames, and one connection. It writes on the
 * calling thread, within the deadline of the link, because a stop must not depend on another thread. Knows nothing of
 * the messages.
 */
@NullMarked
package majic.ros.websocket;

import org.jspecify.annotations.NullMarked;
