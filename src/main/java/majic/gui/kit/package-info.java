/**
 * What the parts of the window are made of: dialogs, colours, pictures, the crossing to the event dispatch thread.
 */
@NullMarked
package majic.gui.kit;

import org.jspecify.annotations.NullMarked;
