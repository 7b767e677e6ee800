package majic.pioneer.parameters;

import java.util.function.Function;
import java.util.function.Supplier;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.pioneer.arcos.ConfigField;
import majic.pioneer.arcos.PioneerIdentity;
import majic.pioneer.state.Equipment;

/** The names and versions of the robot, and settings of its controller. */
final class IdentityParameters implements ParameterTheme<Equipment> {
    private final PioneerAccess access;

    IdentityParameters(PioneerAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, Equipment equipment) {
        table.add(Parameter.text("model", "the model as it reports it"), identity(PioneerIdentity::subclass));
        table.add(Parameter.text("robotName", "the name that is stored in it"), identity(PioneerIdentity::name));
        text(table, "serialNumber", ConfigField.SERNUM, "of the controller");
        text(table, "firmware", ConfigField.FIRMWARE, "version of the controller's program");
        text(table, "bootLoader", ConfigField.BOOTLOADER, "version of the program that starts the firmware");
        number(table, "ticksPerMm", Unit.NONE, ConfigField.TICKSMM, "encoder ticks for a millimetre");
        table.add(
                Parameter.number("watchdog", Unit.MS, "the robot stops after this time without a packet, or never"),
                access.configOrNever(ConfigField.WATCHDOG, Unit.MS, 1));
        number(table, "cycle", Unit.MS, ConfigField.SIPCYCLE, "from one packet of the robot to the next");
    }

    private Supplier<Value> identity(Function<PioneerIdentity, String> part) {
        return access.session(open -> {
            PioneerIdentity known = open.identity();
            return known == null ? Value.unknown("not connected") : Value.text(part.apply(known));
        });
    }

    private void text(ParameterTable table, String name, ConfigField field, String help) {
        table.add(Parameter.text(name, help), access.config(field));
    }

    private void number(ParameterTable table, String name, Unit unit, ConfigField field, String help) {
        table.add(Parameter.number(name, unit, help), access.config(field, unit, 1));
    }
}
