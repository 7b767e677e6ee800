/**
 * The values of the language and what operators make of them.
 */
@NullMarked
package majicsim.aibo.urbi.value;

import org.jspecify.annotations.NullMarked;
