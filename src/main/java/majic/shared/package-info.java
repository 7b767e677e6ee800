/**
 * A robot that another desk shares through an MQTT 5 broker: its driver, its type, its address, and the connections to
 * brokers that all such robots of a program use together.
 */
@NullMarked
package majic.shared;

import org.jspecify.annotations.NullMarked;
