package majic.gui.bots;

import java.util.Locale;
import java.util.OptionalInt;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.Value;

/**
 * The charge of a robot's battery as a card shows it.
 *
 * @param percent 0 to 100; empty if the robot does not report it
 * @param text percent, or the voltage of a robot that reports only that; empty if it reports neither
 */
record BatteryLevel(OptionalInt percent, String text) {
    static final BatteryLevel UNKNOWN = new BatteryLevel(OptionalInt.empty(), "");

    /** Reads the charge; may wait for the robot. */
    static BatteryLevel read(MajicBot bot) {
        if (read(bot, "battery") instanceof Value.Number charge) {
            int percent = (int) Math.round(Math.max(0, Math.min(100, charge.amount())));
            return new BatteryLevel(OptionalInt.of(percent), percent + "%");
        }
        return read(bot, "voltage") instanceof Value.Number volts
                ? new BatteryLevel(OptionalInt.empty(), String.format(Locale.ROOT, "%.1f V", volts.amount()))
                : UNKNOWN;
    }

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
