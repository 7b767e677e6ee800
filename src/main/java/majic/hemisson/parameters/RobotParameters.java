package majic.hemisson.parameters;

import java.util.function.Function;
import java.util.function.Supplier;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.hemisson.line.Identity;
import majic.hemisson.line.Question;
import majic.hemisson.modules.Modules;
import majic.hemisson.readings.RobotReadings;

/** Firmware, modules, switches and the receiver for a remote control. */
final class RobotParameters implements ParameterTheme<Modules> {
    private final RobotReadings access;
    private final Supplier<Identity> robot;

    /**
     * Describes nothing yet.
     *
     * @param robot the robot that answered at connecting
     */
    RobotParameters(RobotReadings access, Supplier<Identity> robot) {
        this.access = access;
        this.robot = robot;
    }

    @Override
    public void describe(ParameterTable table, Modules modules) {
        table.add(
                Parameter.list("switches", Unit.NONE, "the four switches on top; 1, 1, 1, 1 is remote control"),
                access.asked(
                        Question.SWITCHES,
                        switches -> Value.many(switches.numbers().stream()
                                .map(RobotReadings::count)
                                .toList())));
        table.add(
                Parameter.number("tvRemote", Unit.NONE, "the last key of a TV remote control, 0 to 63; 0 before any"),
                access.asked(
                        Question.REMOTE,
                        key -> RobotReadings.count(key.numbers().get(0))));
        table.add(Parameter.text("version", "the firmware"), () -> identified(Identity::version));
        table.add(
                Parameter.text("modules", "what was found on its I2C bus at connecting"),
                () -> identified(identity -> modules.names()));
    }

    private Value identified(Function<Identity, String> text) {
        Identity identity = robot.get();
        return identity == Identity.NONE ? Value.unknown("not connected yet") : Value.text(text.apply(identity));
    }
}
