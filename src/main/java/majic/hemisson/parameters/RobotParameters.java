package majic.hemisson.parameters;

import java.util.function.Function;
import java.util.function.Supplier;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.hemisson.line.Identity;
import majic.hemisson.line.LinkQuality;
import majic.hemisson.line.Question;
import majic.hemisson.modules.Modules;
import majic.hemisson.readings.RobotReadings;

/**
 * Firmware, modules, switches, the receiver for a remote control, and how well the robot answers; also those that other
 * robots have and a Hemisson cannot have, which read as unknown, with the reason.
 */
final class RobotParameters implements ParameterTheme<Modules> {
    private final RobotReadings access;
    private final Supplier<Identity> robot;
    private final Supplier<LinkQuality> quality;

    /**
     * Describes nothing yet.
     *
     * @param robot the robot that answered at connecting
     * @param quality how well it answers
     */
    RobotParameters(RobotReadings access, Supplier<Identity> robot, Supplier<LinkQuality> quality) {
        this.access = access;
        this.robot = robot;
        this.quality = quality;
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
        table.add(
                Parameter.number("roundTrip", Unit.MS, "from a question to its answer, a mean of the last ones"),
                () -> Value.of(quality.get().roundTripMs(), Unit.MS));
        table.add(
                Parameter.number("missedAnswers", Unit.NONE, "that did not come in time, since it was connected"),
                () -> Value.of(quality.get().misses(), Unit.NONE));
        absent(table, "battery", Unit.PERCENT, "no command of the Hemisson tells it");
        absent(table, "voltage", Unit.V, "no command of the Hemisson tells it");
        absent(table, "odometer", Unit.MM, "the Hemisson has no wheel encoders; x, y and heading are estimates");
    }

    private static void absent(ParameterTable table, String name, Unit unit, String reason) {
        table.add(Parameter.number(name, unit, "a Hemisson does not report it"), () -> Value.unknown(reason))
                .kept();
    }

    private Value identified(Function<Identity, String> text) {
        Identity identity = robot.get();
        return identity == Identity.NONE ? Value.unknown("not connected yet") : Value.text(text.apply(identity));
    }
}
