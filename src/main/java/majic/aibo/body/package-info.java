/** The dog's joints, sensors, gaits and LEDs, their readings, and the position estimated from them. */
@NullMarked
package majic.aibo.body;

import org.jspecify.annotations.NullMarked;
