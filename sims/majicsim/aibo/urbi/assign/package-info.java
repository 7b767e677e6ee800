/** Assignments that take time: modifiers, trajectories and the blending of several. */
@NullMarked
package majicsim.aibo.urbi.assign;

import org.jspecify.annotations.NullMarked;
