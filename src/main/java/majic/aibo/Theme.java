package majic.aibo;

import majic.bot.ParameterTable;

/** Parameters of an Aibo that belong together. */
interface Theme {
    /**
     * Describes them.
     *
     * @param table where they stand in the order of the calls
     * @param dialect the generation of the stick, which decides how far the legs may go
     */
    void describe(ParameterTable table, Dialect dialect);
}
