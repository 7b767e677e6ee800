/** ARCOS packets as bytes: checksum, reader, writer and the argument of a command. */
@NullMarked
package majicsim.pioneer.packet;

import org.jspecify.annotations.NullMarked;
