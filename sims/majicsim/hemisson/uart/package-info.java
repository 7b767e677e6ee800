/** The serial line as the firmware drives it: characters at their true speed, and replies with the time they take. */
@NullMarked
package majicsim.hemisson.uart;

import org.jspecify.annotations.NullMarked;
