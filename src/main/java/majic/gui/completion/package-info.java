/** The list of completions for any text component. */
@NullMarked
package majic.gui.completion;

import org.jspecify.annotations.NullMarked;
