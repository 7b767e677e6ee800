package majic.hemisson.modules;

import java.util.List;
import java.util.function.IntConsumer;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.DriverCommand;
import majic.driver.ParameterTable;
import majic.hemisson.readings.RobotReadings;

/** The speech module; the stock commands play the phrases stored in it (Hemisson sheet 9). */
final class Speech implements ExtensionModule {
    private static final int ADDRESS = 0xC4;
    private static final int COMMAND = 0x00;
    private static final int BUSY = 0xFF;
    private static final int PHRASES = 30;

    @Override
    public void describe(ParameterTable table, RobotReadings access) {
        table.add(
                speaking(),
                access.polledWhileRead(
                        Bus.read(ADDRESS, COMMAND, 1),
                        reply -> Value.yesNo(reply.numbers().get(0) == BUSY)));
    }

    @Override
    public List<DriverCommand> commands(RobotReadings access) {
        return List.of(phrase(number -> access.send(Bus.write(ADDRESS, COMMAND, number))));
    }

    /** Whether a phrase is being spoken; both firmwares have this parameter. */
    static Parameter speaking() {
        return Parameter.yesNo("speaking", "whether its voice is busy");
    }

    /** The command that speaks a stored phrase, for both firmwares. */
    static DriverCommand phrase(IntConsumer speak) {
        Parameter number = Parameter.number("number", Unit.NONE, "which one")
                .within(1, PHRASES)
                .inWholes();
        return new DriverCommand("phrase", List.of(number), false, "speaks a stored phrase", (values, motion) -> {
            speak.accept((int) values.get(0).number());
            return "speaks";
        });
    }
}
