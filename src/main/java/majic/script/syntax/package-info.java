/**
 * The pieces of which lines of MAJIC Script consist: tokens, values, names of robots, conditions. Nothing here uses a
 * robot, and nothing here depends on which robots there are.
 */
@NullMarked
package majic.script.syntax;

import org.jspecify.annotations.NullMarked;
