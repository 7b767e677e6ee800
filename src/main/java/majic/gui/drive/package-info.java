/** Driving robots by hand: the pad, the held keys, the game controller. */
@NullMarked
package majic.gui.drive;

import org.jspecify.annotations.NullMarked;
