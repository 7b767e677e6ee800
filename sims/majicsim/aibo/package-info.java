/**
 * A simulated Aibo ERS-7 with the URBI 1.0 server of its memory stick: splitter, lexer, parser, interpreter and the dog's devices.
 * It is written from the URBI sheet alone and may use majicsim.world and majicsim.net, nothing of majic.
 * Everything here is stepped on lab time with the lab's lock held; nothing sleeps and nothing starts a thread.
 */
@NullMarked
package majicsim.aibo;

import org.jspecify.annotations.NullMarked;
