/**
 * What a robot is to the rest of MAJIC: {@link majic.bot.MajicBot}, the parameters and values it deals in, the
 * team it belongs to and the clock all of them live by.
 *
 * <p>Nothing here depends on a particular robot, a protocol, the script language or a window; this package imports no
 * other of MAJIC's.
 */
@NullMarked
package majic.bot;

import org.jspecify.annotations.NullMarked;
