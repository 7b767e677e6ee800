/**
 * Vehicles that speak MAVLink: a rover and a boat as ArduRover 4.6, and a copter as ArduCopter 4.6, in the room of the
 * lab. North is where the room's y axis points. Written from the protocol sheet and a captured session; nothing of
 * MAJIC's driver is used. Everything is guarded by the lab's lock.
 */
@NullMarked
package majicsim.mavlink;

import org.jspecify.annotations.NullMarked;
