/** The values of the language and their operators. */
@NullMarked
package majicsim.aibo.urbi.value;

import org.jspecify.annotations.NullMarked;
