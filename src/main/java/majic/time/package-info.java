/**
 * The clock that drivers, teams, scripts and acts wait and measure by: the clock of the system, or the one of a
 * simulated lab.
 */
@NullMarked
package majic.time;

import org.jspecify.annotations.NullMarked;
