package majic.gui.plot.data;

import java.util.List;
import java.util.stream.IntStream;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;

/**
 * What one curve shows: a parameter of a robot, or one value of a parameter that is a list. Immutable.
 *
 * @param robot the robot's number; {@link #NO_ROBOT} for a computed curve
 * @param parameter the parameter's name, or the formula
 * @param index position in the list, from 0; {@link #WHOLE} for a parameter with a single value
 * @param unit the unit of the values
 * @param switched whether the value is a switch, plotted as 1 and 0 in steps
 */
public record Quantity(int robot, String parameter, int index, Unit unit, boolean switched) {
    /** The index of a parameter with a single value. */
    public static final int WHOLE = -1;

    /** The number that stands for a curve of no single robot. */
    public static final int NO_ROBOT = 0;

    /** Returns what a computed curve shows. */
    static Quantity computed(String formula, Unit unit) {
        return new Quantity(NO_ROBOT, formula, WHOLE, unit, false);
    }

    /** Returns whether the values of a parameter are numbers or switches, or lists of them. */
    public static boolean isPlottable(Parameter parameter) {
        return parameter.readable()
                && switch (parameter.kind()) {
                    case NUMBER, YES_NO, ON_OFF, LIST -> true;
                    case CHOICE, TEXT -> false;
                };
    }

    /**
     * Returns the quantities of a parameter.
     *
     * @param robot the robot's number
     * @param parameter a plottable parameter
     * @param present a value of it; determines the number of quantities of a list
     * @return one, or one for each value of a list; none for a list without values
     */
    public static List<Quantity> of(int robot, Parameter parameter, Value present) {
        if (parameter.kind() == Parameter.Kind.LIST) {
            int length = present instanceof Value.Many many ? many.values().size() : 0;
            return IntStream.range(0, length)
                    .mapToObj(index -> new Quantity(robot, parameter.name(), index, parameter.unit(), false))
                    .toList();
        }
        boolean switched = parameter.kind() != Parameter.Kind.NUMBER;
        return List.of(new Quantity(robot, parameter.name(), WHOLE, parameter.unit(), switched));
    }

    /**
     * Returns the number in a value of the parameter.
     *
     * @return the number in the unit of this quantity; 1 or 0 for a switch; NaN if the value is unknown or nothing is
     *     in range
     */
    public double in(Value value) {
        if (value instanceof Value.Many many) {
            return index >= 0 && index < many.values().size()
                    ? number(many.values().get(index))
                    : Double.NaN;
        }
        return number(value);
    }

    private static double number(Value value) {
        return value instanceof Value.Number || value instanceof Value.Flag ? value.number() : Double.NaN;
    }

    /** Returns the name of the parameter, for instance {@code wheels[1]}. */
    public String name() {
        return index == WHOLE ? parameter : parameter + "[" + index + "]";
    }

    /** Returns robot and name, for instance {@code 1 sonar[3]}; of a computed curve the formula. */
    public String title() {
        return robot == NO_ROBOT ? name() : robot + " " + name();
    }

    /** Returns robot, name and unit, for instance {@code 1 sonar[3] (mm)}. */
    public String label() {
        return title() + unitText();
    }

    /** Returns the unit in brackets behind a blank; empty if there is none. */
    public String unitText() {
        return unitText(unit);
    }

    /** Returns a unit in brackets behind a blank, as {@link #sign}; empty for a plain number. */
    public static String unitText(Unit unit) {
        return unit == Unit.NONE ? "" : " (" + sign(unit) + ")";
    }

    /** Returns a unit as windows show it: {@code °} and {@code °/s} in place of the words of commands. */
    public static String sign(Unit unit) {
        return unit.symbol().replace("deg", "°");
    }
}
