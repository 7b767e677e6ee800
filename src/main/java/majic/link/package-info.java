/**
 * Bytes to and from a robot, over TCP or a serial port. Knows nothing of robots and imports no other package of MAJIC's;
 * meaning begins in the robots' packages.
 */
@NullMarked
package majic.link;

import org.jspecify.annotations.NullMarked;
