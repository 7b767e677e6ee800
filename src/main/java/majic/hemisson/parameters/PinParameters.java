package majic.hemisson.parameters;

import majic.bot.BotException;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.hemisson.line.Question;
import majic.hemisson.modules.Modules;
import majic.hemisson.readings.PolledQuestion;
import majic.hemisson.readings.RobotReadings;

/** Three pins of the extension connector; HemiOS 1.43 and later have commands for them (Hemisson sheet 4.3). */
final class PinParameters implements ParameterTheme<Modules> {
    private static final String[] NAMES = {"pinRB0", "pinRB6", "pinRB7"};

    private final RobotReadings access;
    private final Pins pins;

    PinParameters(RobotReadings access, Pins pins) {
        this.access = access;
        this.pins = pins;
    }

    @Override
    public void describe(ParameterTable table, Modules modules) {
        for (int pin = 0; pin < NAMES.length; pin++) {
            describe(table, pin);
        }
    }

    private void describe(ParameterTable table, int pin) {
        Question level = Question.ask("1," + pin, "1,[01]", 0.5);
        PolledQuestion look = now -> pins.output(pin) == null ? level : null;
        table.add(
                        Parameter.onOff(
                                NAMES[pin],
                                "a pin of the extension connector: an input, from set on an output until a reset"),
                        () -> read(pin, level, look))
                .writes(values -> set(pin, values.get(0).isYes() ? 1 : 0));
    }

    private Value read(int pin, Question question, PolledQuestion look) {
        Integer set = pins.output(pin);
        if (set != null) {
            return Value.onOff(set == 1);
        }
        access.request(look);
        return access.asked(question, reply -> Value.onOff(reply.text().charAt(2) == '1'))
                .get();
    }

    /** Records the output before the command is sent, so that no poll of the pin follows the command. */
    private void set(int pin, int level) {
        Integer before = pins.output(pin);
        pins.becomes(pin, level);
        try {
            access.send(Question.ask("2," + pin + "," + level, "2", 0.4));
        } catch (BotException e) {
            pins.becomes(pin, before);
            throw e;
        }
    }
}
