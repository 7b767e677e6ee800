/** The behaviours that the firmware runs by itself, and the switch that selects them. */
@NullMarked
package majicsim.hemisson.behaviour;

import org.jspecify.annotations.NullMarked;
