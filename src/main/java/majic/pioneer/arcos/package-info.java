/**
 * The packets of ARCOS and its predecessors, the protocol of the Pioneer's controller: bytes to packets, packets to
 * fields as sent, commands to bytes, under the manual's names. Has no socket, thread or clock; scaling and odometry
 * belong to {@code majic.pioneer.state}. Decoding never throws, whatever the bytes; missing fields are absent.
 */
@NullMarked
package majic.pioneer.arcos;

import org.jspecify.annotations.NullMarked;
