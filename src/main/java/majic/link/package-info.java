/** Bytes to and from a robot, over TCP or a serial port. Independent of robots and protocols. */
@NullMarked
package majic.link;

import org.jspecify.annotations.NullMarked;
