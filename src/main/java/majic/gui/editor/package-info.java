/** The script editor: a window of its own, in which scripts and saved sessions are written, checked and run. */
@NullMarked
package majic.gui.editor;

import org.jspecify.annotations.NullMarked;
