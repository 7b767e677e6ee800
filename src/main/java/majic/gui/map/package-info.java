/** The map of the team. */
@NullMarked
package majic.gui.map;

import org.jspecify.annotations.NullMarked;
