/** The terminal: lines that are typed or come from a pipe. */
@NullMarked
package majic.console;

import org.jspecify.annotations.NullMarked;
