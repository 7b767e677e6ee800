package majic.hemisson.parameters;

import java.util.function.Function;
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

/** Firmware, switches and line quality, and the parameters that a Hemisson cannot have. */
public final class RobotParameters implements ParameterTheme<Modules> {
    private final RobotReadings access;
    private final Source source;

    /** What the driver has found out about the robot. Called by any thread. */
    public interface Source {
        /** The robot that answered at connecting. */
        Identity identity();

        /** How well the line works. */
        LinkQuality quality();
    }

    RobotParameters(RobotReadings access, Source source) {
        this.access = access;
        this.source = source;
    }

    @Override
    public void describe(ParameterTable table, Modules modules) {
        describeRobot(table, modules);
        describeLink(table);
        describeWhatItLacks(table);
    }

    private void describeRobot(ParameterTable table, Modules modules) {
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
        Identity identity = source.identity();
        return identity == Identity.NONE ? Value.unknown("not connected yet") : Value.text(text.apply(identity));
    }

    private void describeLink(ParameterTable table) {
        table.add(
                Parameter.number("roundTrip", Unit.MS, "from a question to its answer, a mean of the last ones"),
                () -> Value.of(source.quality().roundTripMs(), Unit.MS));
        table.add(
                Parameter.number("missedAnswers", Unit.NONE, "that did not come in time, since it was connected"),
                () -> Value.of(source.quality().misses(), Unit.NONE));
    }

    private void describeWhatItLacks(ParameterTable table) {
        String noBattery = "no command of the Hemisson tells it";
        lacking(table, Parameter.number("battery", Unit.PERCENT, "a Hemisson does not report it"), noBattery);
        lacking(table, Parameter.number("voltage", Unit.V, "a Hemisson does not report it"), noBattery);
        lacking(
                table,
                Parameter.number("odometer", Unit.MM, "a Hemisson does not report it"),
                "the Hemisson has no wheel encoders; x, y and heading are estimates");
    }

    private void lacking(ParameterTable table, Parameter parameter, String reason) {
        table.add(parameter, () -> Value.unknown(reason));
    }
}
