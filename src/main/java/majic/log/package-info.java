/**
 * What is kept of a session: the session log, written line by line as things happen, and the parameter log, readings
 * taken at a steady pace.
 *
 * <p>Nothing here knows the script language or a window; of MAJIC it imports {@code majic.bot} alone.
 */
@NullMarked
package majic.log;

import org.jspecify.annotations.NullMarked;
