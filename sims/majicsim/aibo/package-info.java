/**
 * A simulated Aibo ERS-7: its joints, lamps, sensors, camera, microphone and speaker, its gaits, and how it stands in the room.
 * What clients send to it is the business of majicsim.aibo.urbi, for which it is hardware. It is written from the URBI sheet
 * alone and may use majicsim.world and majicsim.net, nothing of majic. Everything here is stepped on lab time with the lab's lock
 * held; nothing sleeps and nothing starts a thread.
 */
@NullMarked
package majicsim.aibo;

import org.jspecify.annotations.NullMarked;
