package majic.pioneer;

import majic.bot.ParameterException;
import majic.bot.Value;

/** Numbers that the robot takes only whole. */
final class Whole {
    private Whole() {}

    /**
     * The number in a value.
     *
     * @throws ParameterException if it has a fraction
     */
    static int of(String parameter, Value value) {
        double number = value.number();
        if (number != Math.rint(number)) {
            throw new ParameterException(parameter, parameter + " " + value + ": not a whole number");
        }
        return (int) number;
    }
}
