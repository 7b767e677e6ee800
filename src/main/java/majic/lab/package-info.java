/** Gives the rest of MAJIC access to the simulated lab: its robots' addresses, its clock, its room. */
@NullMarked
package majic.lab;

import org.jspecify.annotations.NullMarked;
