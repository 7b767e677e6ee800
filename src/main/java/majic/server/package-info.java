/** Accepts commands from other programs: a line server on a loopback port, and its clients. */
@NullMarked
package majic.server;

import org.jspecify.annotations.NullMarked;
