/**
 * The clock through which drivers, teams, scripts and acts wait and measure time, of the system or of a simulated lab;
 * which threads may wait; ordered delivery of events; the detection of a suspended computer.
 */
@NullMarked
package majic.time;

import org.jspecify.annotations.NullMarked;
