/** The parameters and commands of a vehicle. */
@NullMarked
package majic.mavlink.parameters;

import org.jspecify.annotations.NullMarked;
