/** Control flow and event handlers as tasks. */
@NullMarked
package majicsim.aibo.urbi.flow;

import org.jspecify.annotations.NullMarked;
