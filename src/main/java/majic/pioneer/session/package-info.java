/**
 * One session with a Pioneer, over any connection: its state, the watchdog, subscriptions, and the control of motions.
 */
@NullMarked
package majic.pioneer.session;

import org.jspecify.annotations.NullMarked;
