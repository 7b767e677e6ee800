/**
 * A Pioneer robot with its ARCOS controller, as a client communicates with it: framing, handshake, motion, sonar,
 * odometry. Written from the ARCOS protocol sheet alone; it shares no code with the driver in {@code majic.pioneer}, so
 * that no misreading is the same on both sides. Sockets and the room are part of the lab, not of this package.
 *
 * <p>Every call must hold the lab's lock; the only clock is the lab's steps.
 */
@NullMarked
package majicsim.pioneer;

import org.jspecify.annotations.NullMarked;
