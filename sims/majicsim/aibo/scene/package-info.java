/**
 * What is visible from a point above the floor: walls, robots, floor and lamps with their colours. Knows nothing of the
 * dog.
 */
@NullMarked
package majicsim.aibo.scene;

import org.jspecify.annotations.NullMarked;
