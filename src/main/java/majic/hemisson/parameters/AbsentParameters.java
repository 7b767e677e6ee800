package majic.hemisson.parameters;

import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.hemisson.modules.Modules;

/** The parameters that other robots have and a Hemisson cannot have: they read as unknown, with the reason. */
final class AbsentParameters implements ParameterTheme<Modules> {
    @Override
    public void describe(ParameterTable table, Modules modules) {
        String noBattery = "no command of the Hemisson tells it";
        add(table, Parameter.number("battery", Unit.PERCENT, "a Hemisson does not report it"), noBattery);
        add(table, Parameter.number("voltage", Unit.V, "a Hemisson does not report it"), noBattery);
        add(
                table,
                Parameter.number("odometer", Unit.MM, "a Hemisson does not report it"),
                "the Hemisson has no wheel encoders; x, y and heading are estimates");
    }

    private static void add(ParameterTable table, Parameter parameter, String reason) {
        table.add(parameter, () -> Value.unknown(reason)).kept();
    }
}
