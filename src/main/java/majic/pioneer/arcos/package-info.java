/**
 * The packets of ARCOS and its forerunners, as the controller of a Pioneer speaks them: bytes to packets, packets to fields
 * as sent, commands to bytes, under the manual's names. No socket, thread or clock, and nothing of what a robot is: scaling,
 * odometry and meaning belong to the driver. Decoding never throws, whatever the bytes; what did not come is absent.
 */
@NullMarked
package majic.pioneer.arcos;

import org.jspecify.annotations.NullMarked;
