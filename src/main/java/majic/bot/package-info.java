/**
 * What programs, behaviours and scripts use of a robot: {@link majic.bot.MajicBot} and {@link majic.bot.BotControl},
 * parameters and values, exceptions, and {@link majic.bot.BotType}, by which the types of robots are found, with the
 * addresses that users type.
 *
 * <p>Nothing here depends on a particular robot, a protocol, the script language or a window. What implements a robot
 * is in {@link majic.driver}.
 */
@NullMarked
package majic.bot;

import org.jspecify.annotations.NullMarked;
