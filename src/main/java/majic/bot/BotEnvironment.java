package majic.bot;

import majic.time.TimeSource;

/**
 * What a robot class needs from around it. Immutable.
 *
 * @param time the clock it lives by
 * @param settings what the user wants remembered
 */
public record BotEnvironment(TimeSource time, Settings settings) {
    /**
     * For a program that just wants a robot: the system's clock, nothing remembered.
     *
     * @return a new environment
     */
    public static BotEnvironment plain() {
        return new BotEnvironment(TimeSource.system(), Settings.inMemory());
    }
}
