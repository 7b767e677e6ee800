/** The answers to {@code help}, and the words that complete a line. */
@NullMarked
package majic.script.help;

import org.jspecify.annotations.NullMarked;
