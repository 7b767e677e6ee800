/**
 * What is known of the dog: its joints, sensors, gaits and LEDs, what they reported, and the position estimated
 * from them.
 */
@NullMarked
package majic.aibo.body;

import org.jspecify.annotations.NullMarked;
