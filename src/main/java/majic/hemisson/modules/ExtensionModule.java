package majic.hemisson.modules;

import java.util.List;
import majic.driver.DriverCommand;
import majic.driver.ParameterTable;
import majic.hemisson.readings.RobotReadings;

/** A module on the extension connector that the robot has commands for (Hemisson sheet 9). */
interface ExtensionModule {
    /** Adds its parameters. */
    void describe(ParameterTable table, RobotReadings access);

    /** Its commands. */
    default List<DriverCommand> commands(RobotReadings access) {
        return List.of();
    }
}
