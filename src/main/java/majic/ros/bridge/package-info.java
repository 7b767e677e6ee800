/**
 * The client of the protocol rosbridge v2: operations as JSON over a WebSocket. Calls services, publishes and
 * subscribes to topics, sends goals of actions. Knows no robots.
 */
@NullMarked
package majic.ros.bridge;

import org.jspecify.annotations.NullMarked;
