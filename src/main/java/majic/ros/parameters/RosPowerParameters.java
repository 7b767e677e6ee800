package majic.ros.parameters;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.function.Supplier;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.ros.message.BatteryMessage;
import majic.ros.message.BatteryMessage.Supply;
import majic.ros.readings.RosSensors;

/** The battery. */
final class RosPowerParameters implements ParameterTheme<RosSensors> {
    private final RosAccess access;

    RosPowerParameters(RosAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, RosSensors sensors) {
        if (sensors.battery().isEmpty()) {
            return;
        }
        table.add(
                Parameter.number("battery", Unit.PERCENT, "charge left"), read(battery -> percent(battery.percent())));
        table.add(Parameter.number("voltage", Unit.V, "of the battery"), read(battery -> volts(battery.volts())));
        List<String> words = Arrays.stream(Supply.values()).map(Supply::words).toList();
        table.add(
                Parameter.choice("charging", words, "what the charger does"),
                read(battery -> supply(battery.supply())));
    }

    private Supplier<Value> read(Function<BatteryMessage, Value> reader) {
        return access.read(readings -> readings.battery()
                .get()
                .map(reader)
                .orElseGet(() -> readings.battery().unknown()));
    }

    private static Value percent(OptionalDouble percent) {
        return percent.isEmpty()
                ? Value.unknown("this robot does not report its charge")
                : Value.of(percent.getAsDouble(), Unit.PERCENT);
    }

    private static Value volts(OptionalDouble volts) {
        return volts.isEmpty()
                ? Value.unknown("this robot does not report its voltage")
                : Value.of(volts.getAsDouble(), Unit.V);
    }

    private static Value supply(Supply supply) {
        return supply == Supply.UNKNOWN ? Value.unknown("this robot does not report it") : Value.text(supply.words());
    }
}
