/**
 * A simulated Aibo ERS-7: its joints, LEDs, sensors, camera, microphone and speaker, its gaits, and its pose in the room.
 * The package majicsim.aibo.urbi executes what clients send; this package is its hardware. It is written from the URBI sheet
 * alone and may use majicsim.world and majicsim.net, nothing of majic. Everything here is stepped on lab time with the lab's lock
 * held; nothing sleeps and nothing starts a thread.
 */
@NullMarked
package majicsim.aibo;

import org.jspecify.annotations.NullMarked;
