/**
 * The recording of everything that the robots of a team report, and of the lines of the session: writes it to bounded
 * files in the background, and reads such files for plots and replays. {@code docs/recordings.md} describes the files.
 */
@NullMarked
package majic.recorder;

import org.jspecify.annotations.NullMarked;
