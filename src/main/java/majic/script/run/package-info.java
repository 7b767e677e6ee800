/**
 * Checks and runs scripts: the interface of a command, statements, the checker, the interpreter, and one line or script
 * while it runs. The commands themselves are in {@code majic.script.commands}.
 */
@NullMarked
package majic.script.run;

import org.jspecify.annotations.NullMarked;
