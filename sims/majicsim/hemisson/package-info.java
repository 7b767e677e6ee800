/**
 * The simulated Hemisson: HemiOS 1.50's serial protocol byte for byte, its open-loop motors and its infra-red sensors,
 * written from the Hemisson sheet alone. Uses the world and the lines; shares nothing with any driver.
 */
@NullMarked
package majicsim.hemisson;

import org.jspecify.annotations.NullMarked;
