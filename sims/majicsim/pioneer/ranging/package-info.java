/** Sonar and laser: firing order, echoes from the room, readings. */
@NullMarked
package majicsim.pioneer.ranging;

import org.jspecify.annotations.NullMarked;
