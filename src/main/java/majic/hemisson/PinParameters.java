package majic.hemisson;

import majic.bot.Parameter;
import majic.bot.ParameterTable;

/** Three pins of the extension connector; HemiOS 1.43 and later have commands for them (Hemisson sheet 4.3). */
final class PinParameters {
    private static final String[] PINS = {"pinRB0", "pinRB6", "pinRB7"};

    private final ParameterTable table;
    private final Access access;

    PinParameters(ParameterTable table, Access access) {
        this.table = table;
        this.access = access;
    }

    void describe() {
        for (int index = 0; index < PINS.length; index++) {
            pin(index).describeSwitch(table, access, Parameter.onOff(PINS[index], "a pin of the extension connector"));
        }
    }

    private static Dial pin(int index) {
        return new Dial(
                Question.ask("1," + index, "1,[01]", 0.5),
                reply -> reply.text().charAt(2) - '0',
                level -> Question.ask("2," + index + "," + level, "2", 0.4));
    }
}
