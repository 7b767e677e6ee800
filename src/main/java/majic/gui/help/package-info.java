/** Help: the tables of commands, parameters and keys, the pages of the documents, and the program's version. */
@NullMarked
package majic.gui.help;

import org.jspecify.annotations.NullMarked;
