package majic.hemisson.modules;

import java.util.List;
import majic.bot.BotCommand;
import majic.bot.ParameterTable;
import majic.hemisson.readings.Access;

/** Something plugged into the extension connector, as far as the robot can be asked about it (Hemisson sheet 9). */
interface ExtensionModule {
    /** Adds its parameters. */
    void describe(ParameterTable table, Access access);

    /** Its commands. */
    default List<BotCommand> commands(Access access) {
        return List.of();
    }
}
