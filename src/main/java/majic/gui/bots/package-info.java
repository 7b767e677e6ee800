/** The tabbed panes of the robots. */
@NullMarked
package majic.gui.bots;

import org.jspecify.annotations.NullMarked;
