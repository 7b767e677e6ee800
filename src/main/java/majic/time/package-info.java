/**
 * The clock that drivers, teams, scripts and acts wait and measure by, of the system or of a simulated lab; which
 * threads may wait; events that are delivered in order; and the detection of a suspended computer.
 */
@NullMarked
package majic.time;

import org.jspecify.annotations.NullMarked;
