/**
 * The connection to an MQTT 5 broker: its address, the credentials, TLS, and messages that are published and received.
 * Contains nothing about robots and topics.
 */
@NullMarked
package majic.shared.broker;

import org.jspecify.annotations.NullMarked;
