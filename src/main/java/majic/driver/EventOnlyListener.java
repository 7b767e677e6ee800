package majic.driver;

import majic.bot.BotListener;

/**
 * A listener whose {@link #stateChanged} is not called. While a robot has no other listeners, new readings do not wake
 * its listener thread, which saves a tenth of the processor time of a robot that reports.
 */
public interface EventOnlyListener extends BotListener {}
