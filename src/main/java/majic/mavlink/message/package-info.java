/** Messages of MAVLink as typed values, and the messages that MAJIC sends. Has no link, thread or clock. */
@NullMarked
package majic.mavlink.message;

import org.jspecify.annotations.NullMarked;
