/**
 * The MobileRobots Pioneer: a client of the ARCOS protocol and the driver above it. Bytes become frames in the decoder,
 * frames become packets with fields, packets become a state, and only the driver knows what a robot is. Nothing here
 * knows another robot, and only the panel knows Swing.
 */
@NullMarked
package majic.pioneer;

import org.jspecify.annotations.NullMarked;
