/** Submitted lines: checks them, and runs each at once, beside others or in its turn. */
@NullMarked
package majic.script.lines;

import org.jspecify.annotations.NullMarked;
