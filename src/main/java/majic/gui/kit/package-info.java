/**
 * Components shared by the parts of the window: dialogs, colours, icons, tasks on and off the event dispatch thread.
 */
@NullMarked
package majic.gui.kit;

import org.jspecify.annotations.NullMarked;
