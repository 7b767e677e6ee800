/**
 * Bytes to and from a robot, over TCP or a serial port. Independent of robots and protocols; uses no other package of
 * MAJIC.
 */
@NullMarked
package majic.link;

import org.jspecify.annotations.NullMarked;
