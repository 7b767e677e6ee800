/**
 * MAJIC Script: text to commands for robots. {@link majic.script.MajicParser} takes lines and
 * {@link majic.script.Session} sends the answers.
 *
 * <p>Syntax makes a tree of a line, each command of the tree gets an action, and actions are checked before they run;
 * nothing before that moves a robot. Nothing here depends on a particular type of robot or on a window.
 */
@NullMarked
package majic.script;

import org.jspecify.annotations.NullMarked;
