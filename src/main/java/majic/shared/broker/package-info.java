/**
 * The connection to an MQTT 5 broker: its address, the credentials, TLS, and messages that are published and received.
 * Knows no robots and no topics.
 */
@NullMarked
package majic.shared.broker;

import org.jspecify.annotations.NullMarked;
