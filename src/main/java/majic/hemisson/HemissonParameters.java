package majic.hemisson;

import majic.bot.ParameterTable;

/** What can be read from and set on every Hemisson; {@link Modules} adds what is plugged in. */
final class HemissonParameters {
    private HemissonParameters() {}

    static void describe(ParameterTable table, Access access) {
        new InfraredParameters(table, access).describe();
        new LampParameters(table, access.bot().lamps()).describe();
        new WheelParameters(table, access).describe();
        new RobotParameters(table, access).describe();
        new PinParameters(table, access).describe();
    }
}
