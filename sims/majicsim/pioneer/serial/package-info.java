/** The serial line between client and controller: its speed, and the bytes read at a wrong one. */
@NullMarked
package majicsim.pioneer.serial;

import org.jspecify.annotations.NullMarked;
