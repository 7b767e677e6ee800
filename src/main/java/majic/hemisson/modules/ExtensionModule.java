package majic.hemisson.modules;

import java.util.List;
import majic.bot.BotCommand;
import majic.bot.ParameterTable;
import majic.hemisson.readings.RobotReadings;

/** Something plugged into the extension connector, as far as the robot can be asked about it (Hemisson sheet 9). */
interface ExtensionModule {
    /** Adds its parameters. */
    void describe(ParameterTable table, RobotReadings access);

    /** Its commands. */
    default List<BotCommand> commands(RobotReadings access) {
        return List.of();
    }
}
