/**
 * One connection to a Pioneer: handshake, packets, watchdog, subscriptions, and the motions steered over it.
 */
@NullMarked
package majic.pioneer.session;

import org.jspecify.annotations.NullMarked;
