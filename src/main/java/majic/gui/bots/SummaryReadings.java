package majic.gui.bots;

import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.Value;

/**
 * What a tab shows of the parameters of its robot. Immutable.
 *
 * @param battery the charge
 * @param stopPressed whether the STOP button on the robot is pressed; false for a robot without one
 */
record SummaryReadings(BatteryLevel battery, boolean stopPressed) {
    static final SummaryReadings NONE = new SummaryReadings(BatteryLevel.UNKNOWN, false);

    private static final String STOP_BUTTON = "stopButton";

    /** Reads the parameters; may wait for the robot. */
    static SummaryReadings of(MajicBot bot) {
        boolean pressed = read(bot, STOP_BUTTON) instanceof Value.Flag button && button.yes();
        return new SummaryReadings(BatteryLevel.of(parameter -> read(bot, parameter)), pressed);
    }

    /** Reads a parameter; a robot that does not have it gives an unknown value. */
    private static Value read(MajicBot bot, String parameter) {
        boolean known =
                bot.parameters().stream().anyMatch(offered -> offered.name().equals(parameter) && offered.readable());
        try {
            return known ? bot.get(parameter) : new Value.Unknown("");
        } catch (BotException e) {
            return new Value.Unknown(String.valueOf(e.getMessage()));
        }
    }
}
