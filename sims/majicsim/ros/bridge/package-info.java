/** The rosbridge v2 server: its clients, and what each operation of the protocol does (sheet 1 to 3 and 6). */
@NullMarked
package majicsim.ros.bridge;

import org.jspecify.annotations.NullMarked;
