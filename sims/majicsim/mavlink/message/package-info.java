/** MAVLink 1 and 2 as bytes: frames, checksums, and the messages that a vehicle and a ground station exchange. */
@NullMarked
package majicsim.mavlink.message;

import org.jspecify.annotations.NullMarked;
