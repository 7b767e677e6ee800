/**
 * A Pioneer robot with its ARCOS controller, as a client meets it on the wire: framing, handshake, motion, sonar,
 * odometry. Written from the ARCOS protocol sheet alone; it shares no code with the driver in {@code majic.pioneer},
 * so that one misreading cannot hide on both sides. Sockets and the room belong to the lab, not here.
 *
 * <p>Everything is called with the lab's lock held and uses no clock but the lab's steps.
 */
@NullMarked
package majicsim.pioneer;

import org.jspecify.annotations.NullMarked;
