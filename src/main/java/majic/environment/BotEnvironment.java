package majic.environment;

import majic.time.TimeSource;

/**
 * The clock and the settings that a robot's driver uses. Immutable.
 *
 * @param time the clock for all its waits and measurements
 * @param settings the settings kept between program starts
 */
public record BotEnvironment(TimeSource time, Settings settings) {
    /**
     * For a program that uses a robot directly: the system's clock, no settings kept.
     *
     * @return a new environment
     */
    public static BotEnvironment plain() {
        return new BotEnvironment(TimeSource.system(), Settings.inMemory());
    }
}
