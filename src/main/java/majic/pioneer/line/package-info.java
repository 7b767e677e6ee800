/**
 * The connection to a Pioneer by ARCOS packets over TCP or a serial port: the packets of one link, the handshake, the
 * speed of a serial line.
 */
@NullMarked
package majic.pioneer.line;

import org.jspecify.annotations.NullMarked;
