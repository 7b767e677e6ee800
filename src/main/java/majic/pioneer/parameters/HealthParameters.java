package majic.pioneer.parameters;

import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.pioneer.state.Equipment;

/** The power of the motors, temperature and faults of the controller. */
final class HealthParameters implements ParameterTheme<Equipment> {
    private final PioneerAccess access;
    private final PowerSwitches switches;

    HealthParameters(PioneerAccess access, PowerSwitches switches) {
        this.access = access;
        this.switches = switches;
    }

    @Override
    public void describe(ParameterTable table, Equipment equipment) {
        table.add(
                        Parameter.yesNo("motors", "whether the motors are on"),
                        access.state(state -> Value.yesNo(state.motorsOn())))
                .writes(values -> switches.motors(values.get(0).isYes()));
        table.add(
                Parameter.number("temperature", Unit.CELSIUS, "of the controller, where it has a thermometer"),
                access.state(state -> state.temperatureC().isEmpty()
                        ? PioneerAccess.NOT_REPORTED
                        : Value.of(state.temperatureC().getAsInt(), Unit.CELSIUS)));
        table.add(
                Parameter.number("faults", Unit.NONE, "the controller's fault flags as one number, 0 when all is well"),
                access.state(state -> state.faults().isEmpty()
                        ? PioneerAccess.NOT_REPORTED
                        : Value.of(state.faults().getAsInt(), Unit.NONE)));
    }
}
