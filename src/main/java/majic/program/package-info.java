/** The running program: its team, session, settings, plug-ins and window. */
@NullMarked
package majic.program;

import org.jspecify.annotations.NullMarked;
