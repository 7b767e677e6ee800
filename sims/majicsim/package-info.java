/**
 * The simulated lab: one room, its robots and their ports. It imports nothing of MAJIC, and its robots are written from
 * the protocol sheets and not from the drivers, so that no misreading is the same on both sides.
 */
@NullMarked
package majicsim;

import org.jspecify.annotations.NullMarked;
