/**
 * The lines of the simulated lab: TCP ports and a pseudo-terminal on which robots' firmwares are reached, the faults
 * that can be ordered for them, and the counters by which a stepped clock detects that nothing is in flight.
 * Independent of any robot's protocol. Lines are served by daemon threads of their own; the firmware is called only
 * with the lab's lock held.
 */
@NullMarked
package majicsim.net;

import org.jspecify.annotations.NullMarked;
