/**
 * The URBI 1.0 server of the simulated dog: its connections, its cycle, its reset and its memory stick. The language is
 * in the packages below. It has no hardware of its own: the dog adds variables and functions, and advances its time.
 * Written from the URBI sheet alone; everything is called with the lab's lock held.
 */
@NullMarked
package majicsim.aibo.urbi;

import org.jspecify.annotations.NullMarked;
