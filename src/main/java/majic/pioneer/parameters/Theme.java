package majic.pioneer.parameters;

import majic.bot.ParameterTable;
import majic.pioneer.state.Equipment;

/** Parameters of a Pioneer that belong together. */
interface Theme {
    /**
     * Describes them, those left out that this robot cannot have.
     *
     * @param table where they stand in the order of the calls
     */
    void describe(ParameterTable table, Equipment equipment);

    /** Ends what it has made the robot do, when somebody stops the robot; waits for nothing. */
    default void halt() {}
}
