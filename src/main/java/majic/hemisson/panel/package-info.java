/** The panel that shows one Hemisson. All that it sends are clicks on LEDs and the buzzer. */
@NullMarked
package majic.hemisson.panel;

import org.jspecify.annotations.NullMarked;
