/**
 * The board without firmware: motors, sensors, switches, battery, remote control receiver and the memory of the
 * controller.
 */
@NullMarked
package majicsim.hemisson.board;

import org.jspecify.annotations.NullMarked;
