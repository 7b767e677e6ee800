package majic.gui.bots;

import java.util.Locale;
import java.util.OptionalInt;
import java.util.function.Function;
import majic.bot.Value;

/**
 * The charge of a robot's battery as a tab shows it.
 *
 * @param parameter name of the parameter that it comes from
 * @param percent 0 to 100; empty if the robot does not report it
 * @param text percent, or the voltage of a robot that reports only that; empty if it reports neither
 */
public record BatteryLevel(String parameter, OptionalInt percent, String text) {
    private static final String CHARGE = "battery";
    private static final String VOLTAGE = "voltage";

    public static final BatteryLevel UNKNOWN = new BatteryLevel(CHARGE, OptionalInt.empty(), "");

    /** Reads the charge from the values of parameters by their names; unknown parameters have unknown values. */
    public static BatteryLevel of(Function<String, Value> values) {
        if (values.apply(CHARGE) instanceof Value.Number charge) {
            int percent = (int) Math.round(Math.max(0, Math.min(100, charge.amount())));
            return new BatteryLevel(CHARGE, OptionalInt.of(percent), percent + " %");
        }
        return values.apply(VOLTAGE) instanceof Value.Number volts
                ? new BatteryLevel(VOLTAGE, OptionalInt.empty(), String.format(Locale.ROOT, "%.1f V", volts.amount()))
                : UNKNOWN;
    }
}
