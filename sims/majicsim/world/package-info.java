/**
 * The room of the simulated lab and the rigid bodies in it: walls, poses, motion, rays, light, and the one source of
 * noise. Millimetres, degrees counter-clockwise and seconds throughout. Independent of robots, protocols, threads and
 * real time; a {@link majicsim.world.World} that several threads use is guarded by the lab's lock.
 */
@NullMarked
package majicsim.world;

import org.jspecify.annotations.NullMarked;
