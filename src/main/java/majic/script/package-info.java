/**
 * MAJIC Script: from a line of text to orders for robots. {@link majic.script.MajicParser} takes lines,
 * {@link majic.script.Session} tells what became of them.
 *
 * <p>The scanner makes tokens, the parser a tree, the checker finds what cannot work, and the interpreter alone gives
 * orders; nothing before it moves a robot. No particular robot and no window is known here.
 */
@NullMarked
package majic.script;

import org.jspecify.annotations.NullMarked;
