package majic.hemisson.modules;

import java.util.Locale;
import java.util.function.Function;
import java.util.function.IntFunction;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.hemisson.line.Question;
import majic.hemisson.line.Reply;
import majic.hemisson.readings.RobotReadings;

/**
 * A number of a module that can be read and set. Immutable.
 *
 * @param get asks for it
 * @param number finds it in the answer
 * @param set sets it, 0 to 255
 */
record ModuleNumber(Question get, Function<Reply, Integer> number, IntFunction<Question> set) {
    /** A register (Hemisson sheet 9). */
    static ModuleNumber register(int address, int register) {
        return new ModuleNumber(
                Bus.read(address, register, 1),
                reply -> reply.numbers().get(0),
                value -> Bus.write(address, register, value));
    }

    /** A pair of module commands of the RoadNarrows firmware (sheet 10), with a number in hex. */
    static ModuleNumber roadNarrows(char module, char getter, char setter) {
        String asked = "A," + module + "," + getter;
        String set = "A," + module + "," + setter + ",";
        return new ModuleNumber(
                Question.ask(asked, "a," + module + "," + getter + ",[0-9A-Fa-f]{1,2}", Question.msFor(8)),
                reply -> Integer.parseInt(reply.text().substring(asked.length() + 1), 16),
                value -> Question.ask(
                        set + String.format(Locale.ROOT, "%02X", value),
                        "a," + module + "," + setter + "(,.*)?",
                        Question.msFor(8)));
    }

    /** Adds it as a parameter with numbers. */
    void describe(ParameterTable table, RobotReadings access, Parameter parameter) {
        table.add(
                        parameter.inWholes(),
                        access.polledWhileRead(get, reply -> Value.of(number.apply(reply), parameter.unit())))
                .writes(values -> access.send(set.apply((int) values.get(0).number())));
    }

    /** Adds it as a parameter that is on or off. */
    void describeSwitch(ParameterTable table, RobotReadings access, Parameter parameter) {
        table.add(parameter, access.polledWhileRead(get, reply -> Value.onOff(number.apply(reply) != 0)))
                .writes(values -> access.send(set.apply(values.get(0).isYes() ? 1 : 0)));
    }
}
