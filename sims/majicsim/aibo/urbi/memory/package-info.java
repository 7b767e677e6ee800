/** Everything that programs give names to: variables, groups, objects and events. */
@NullMarked
package majicsim.aibo.urbi.memory;

import org.jspecify.annotations.NullMarked;
