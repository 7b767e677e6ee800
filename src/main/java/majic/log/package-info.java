/**
 * Distributes the lines of a session to the session log, written as they come, and to all listeners; and holds the
 * parameter log: readings taken at regular intervals.
 */
@NullMarked
package majic.log;

import org.jspecify.annotations.NullMarked;
