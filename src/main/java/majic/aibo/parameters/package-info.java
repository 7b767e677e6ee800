/** The parameters of the dog and the raw URBI command. */
@NullMarked
package majic.aibo.parameters;

import org.jspecify.annotations.NullMarked;
