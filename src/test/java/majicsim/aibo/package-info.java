/** Tests of the simulated Aibo against the transcripts of the real kernel. */
@NullMarked
package majicsim.aibo;

import org.jspecify.annotations.NullMarked;
