/** From text to a tree of commands: splitter, scanner, parser and the tree, which does not run by itself. */
@NullMarked
package majicsim.aibo.urbi.syntax;

import org.jspecify.annotations.NullMarked;
