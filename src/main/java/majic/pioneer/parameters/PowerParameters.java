package majic.pioneer.parameters;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.pioneer.arcos.ConfigField;
import majic.pioneer.state.Charging;
import majic.pioneer.state.Equipment;

/** Battery and charger. */
final class PowerParameters implements ParameterTheme<Equipment> {
    private final PioneerAccess access;

    PowerParameters(PioneerAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, Equipment equipment) {
        table.add(
                Parameter.number("voltage", Unit.V, "of the battery; charge a 12 V robot below 11.5"),
                access.state(state -> Value.of(state.volts(), Unit.V)));
        table.add(
                Parameter.number("battery", Unit.PERCENT, "charge, on robots that report it"),
                access.state(state -> charge(state.power().percent())));
        table.add(
                Parameter.number("lowVoltage", Unit.V, "below it the robot gives an alarm, or never"),
                access.configOrNever(ConfigField.LOWBATTERY, Unit.V, 10));
        List<String> words =
                Arrays.stream(Charging.values()).map(Charging::words).toList();
        table.add(
                Parameter.choice("charging", words, "what the charger does"),
                access.state(state -> charging(state.power().charging())));
        table.add(
                Parameter.yesNo("charger", "whether a charger is connected and its supply good"),
                access.state(state -> Value.yesNo(state.power().chargerConnected())));
    }

    private static Value charge(OptionalInt percent) {
        return percent.isEmpty()
                ? Value.unknown("this robot reports only its voltage")
                : Value.of(percent.getAsInt(), Unit.PERCENT);
    }

    private static Value charging(Charging charging) {
        return charging == Charging.UNKNOWN ? PioneerAccess.NOT_REPORTED : Value.text(charging.words());
    }
}
