/** Command line and message area. */
@NullMarked
package majic.gui.command;

import org.jspecify.annotations.NullMarked;
