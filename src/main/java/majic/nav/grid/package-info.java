/** Occupancy grids: what is free, occupied and unknown, drawn from scans or read from files. */
@NullMarked
package majic.nav.grid;

import org.jspecify.annotations.NullMarked;
