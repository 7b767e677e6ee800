/**
 * One connection to a dog from connect to disconnect: gaits, postures and joints, the stop, and the guard against a
 * lost connection.
 */
@NullMarked
package majic.aibo.session;

import org.jspecify.annotations.NullMarked;
