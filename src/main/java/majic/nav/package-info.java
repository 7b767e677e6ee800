/** The map of a team: opened from a file, or built by a robot while it drives. */
@NullMarked
package majic.nav;

import org.jspecify.annotations.NullMarked;
