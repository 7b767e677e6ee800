/** The conversation with one client: handshake, commands, watchdog and end, and the simulator's own commands. */
@NullMarked
package majicsim.pioneer.session;

import org.jspecify.annotations.NullMarked;
