/**
 * Driving a robot by hand: the pad and the held keys.
 */
@NullMarked
package majic.gui.drive;

import org.jspecify.annotations.NullMarked;
