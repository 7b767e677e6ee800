/**
 * A simulated Aibo ERS-7: its hardware put together, the devices by which its URBI server reaches that, and what can be
 * done to it by hand. The package majicsim.aibo.urbi executes what clients send; the others are the hardware. All is
 * written from the URBI sheet alone and may use majicsim.world and majicsim.net, nothing of majic. Everything here is
 * stepped on lab time with the lab's lock held; nothing sleeps and nothing starts a thread.
 */
@NullMarked
package majicsim.aibo;

import org.jspecify.annotations.NullMarked;
