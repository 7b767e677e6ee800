/**
 * Connections to vehicles: TCP, UDP or serial ports, each of which several vehicles may share. Sorts what arrives by
 * the vehicles that sent it, and sends to each in its version of the protocol.
 */
@NullMarked
package majic.mavlink.line;

import org.jspecify.annotations.NullMarked;
