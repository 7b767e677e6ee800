package majic.gui.bots;

import majic.bot.MajicBot;
import majic.bot.Value;

/**
 * What a card shows of the parameters of its robot. Immutable.
 *
 * @param battery the charge
 * @param stopPressed whether the STOP button on the robot is pressed; false for a robot without one
 */
record CardReadings(BatteryLevel battery, boolean stopPressed) {
    static final CardReadings NONE = new CardReadings(BatteryLevel.UNKNOWN, false);

    private static final String STOP_BUTTON = "stopButton";

    /** Reads the parameters; may wait for the robot. */
    static CardReadings of(MajicBot bot) {
        boolean pressed = BatteryLevel.read(bot, STOP_BUTTON) instanceof Value.Flag button && button.yes();
        return new CardReadings(BatteryLevel.read(bot), pressed);
    }
}
