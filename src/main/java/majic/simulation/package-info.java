/** The simulated lab inside this program: it starts the simulators and steps or paces their clock. */
@NullMarked
package majic.simulation;

import org.jspecify.annotations.NullMarked;
