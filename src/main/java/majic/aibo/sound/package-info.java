/** The dog's loudspeaker and microphone, and the sound files on the computer. */
@NullMarked
package majic.aibo.sound;

import org.jspecify.annotations.NullMarked;
