/**
 * The syntax of MAJIC Script: text to tokens, tokens to a tree of commands. Nothing here uses a robot, and nothing here
 * depends on which robots there are.
 */
@NullMarked
package majic.script.syntax;

import org.jspecify.annotations.NullMarked;
