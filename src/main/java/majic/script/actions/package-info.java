/** The action of each command of MAJIC Script, and the table that makes them. */
@NullMarked
package majic.script.actions;

import org.jspecify.annotations.NullMarked;
