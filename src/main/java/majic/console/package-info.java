/**
 * The terminal: lines from a person or a pipe.
 */
@NullMarked
package majic.console;

import org.jspecify.annotations.NullMarked;
