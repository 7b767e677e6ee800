/**
 * Accepts commands from other programs: a line server on a loopback port, or with TLS for other computers; its clients,
 * their token and their limits.
 */
@NullMarked
package majic.server;

import org.jspecify.annotations.NullMarked;
