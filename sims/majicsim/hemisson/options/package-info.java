/** What a simulated Hemisson is: its firmware's dialect, its modules and its switches. */
@NullMarked
package majicsim.hemisson.options;

import org.jspecify.annotations.NullMarked;
