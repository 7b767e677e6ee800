package majic.hemisson.modules;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import majic.bot.BotException;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.DriverCommand;
import majic.driver.ParameterTable;
import majic.hemisson.readings.RobotReadings;

/** The display of two lines with its three keys (Hemisson sheet 9). */
final class Lcd implements ExtensionModule {
    private static final int ADDRESS = 0xA0;
    private static final int KEYS = 0x10;
    private static final int CLEAR_ALL = 0x30;

    /** Registers that take text. */
    private static final Map<String, Integer> LINES = new TreeMap<>(Map.of(
            "upper", 0x10,
            "upperCentre", 0x12,
            "upperRight", 0x13,
            "lower", 0x20,
            "lowerCentre", 0x22,
            "lowerRight", 0x23));

    @Override
    public void describe(ParameterTable table, RobotReadings access) {
        table.add(
                Parameter.number("lcdKeys", Unit.NONE, "which of the display's three keys are pressed, as a number"),
                access.polledWhileRead(
                        Bus.read(ADDRESS, KEYS, 1),
                        reply -> RobotReadings.count(reply.numbers().get(0))));
        writeOnly(table, access, Parameter.onOff("lcdLight", "the light behind the display"), 0x40);
        writeOnly(
                table,
                access,
                Parameter.number("lcdContrast", Unit.NONE, "of the display")
                        .within(0, 255)
                        .inWholes(),
                0x41);
    }

    private static void writeOnly(ParameterTable table, RobotReadings access, Parameter parameter, int register) {
        table.addWriteOnly(parameter)
                .writes(values -> access.send(
                        Bus.write(ADDRESS, register, (int) values.get(0).number())));
    }

    @Override
    public List<DriverCommand> commands(RobotReadings access) {
        Parameter line = Parameter.choice("line", List.copyOf(LINES.keySet()), "where");
        Parameter text = Parameter.text("text", "at most " + Bus.MOST_BYTES + " letters");
        DriverCommand write = new DriverCommand(
                "lcd", List.of(line, text), false, "writes on the display", (values, motion) -> write(access, values));
        DriverCommand clear =
                new DriverCommand("lcdClear", List.of(), false, "clears the display", (values, motion) -> {
                    access.send(Bus.write(ADDRESS, CLEAR_ALL, 0));
                    return "cleared";
                });
        return List.of(write, clear);
    }

    private static String write(RobotReadings access, List<Value> values) {
        String text = values.get(1).toString();
        if (!text.matches("[ -~]{1," + Bus.MOST_BYTES + "}")) {
            throw new BotException(
                    "lcd: 1 to " + Bus.MOST_BYTES + " letters and signs of plain English, not \"" + text + "\"");
        }
        List<Integer> bytes = text.chars().boxed().toList();
        access.send(Bus.write(ADDRESS, LINES.get(values.get(0).toString()), bytes));
        return "written";
    }
}
