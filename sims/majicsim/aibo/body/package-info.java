/** The dog's body: joints, legs, head, gaits and postures, and the sensors in it. */
@NullMarked
package majicsim.aibo.body;

import org.jspecify.annotations.NullMarked;
