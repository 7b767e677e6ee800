/**
 * The simulated lab as the rest of MAJIC sees it: its robots' addresses, its clock, its room.
 */
@NullMarked
package majic.lab;

import org.jspecify.annotations.NullMarked;
