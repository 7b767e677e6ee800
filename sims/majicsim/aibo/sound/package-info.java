/** The dog's loudspeaker and microphones, and the sounds on its memory stick. */
@NullMarked
package majicsim.aibo.sound;

import org.jspecify.annotations.NullMarked;
