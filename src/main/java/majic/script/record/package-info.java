/** What was done in a session, with its times, and the script that does it again. */
@NullMarked
package majic.script.record;

import org.jspecify.annotations.NullMarked;
