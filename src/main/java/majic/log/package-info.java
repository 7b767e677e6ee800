/**
 * The lines of a session and where they go: to the session log, written as they come, and to all listeners. And the
 * parameter log: readings taken at a steady pace.
 */
@NullMarked
package majic.log;

import org.jspecify.annotations.NullMarked;
