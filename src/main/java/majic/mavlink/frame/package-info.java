/**
 * The frames of MAVLink 1 and 2: bytes to frames, frames to bytes, the fields of a payload. Has no link, thread or
 * clock.
 */
@NullMarked
package majic.mavlink.frame;

import org.jspecify.annotations.NullMarked;
