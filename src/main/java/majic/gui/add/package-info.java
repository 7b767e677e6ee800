/** The dialog that adds a robot. */
@NullMarked
package majic.gui.add;

import org.jspecify.annotations.NullMarked;
