package majic.script.commands;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.Parameter;

/**
 * Parameters that differ in nothing but the number at the end of their names, one higher each, such as {@code sonar0}
 * to {@code sonar15}, so that lists for users need one line for them. Immutable.
 *
 * @param first the one with the first number
 * @param last the one with the last number; equal to the first for a single parameter
 */
public record ParameterGroup(Parameter first, Parameter last) {
    private static final Pattern NUMBERED = Pattern.compile("(.*\\D)(\\d{1,9})");

    /**
     * Groups what follows one another.
     *
     * @param parameters in a table's order
     * @return all of them, in the same order
     */
    public static List<ParameterGroup> of(List<Parameter> parameters) {
        List<ParameterGroup> groups = new ArrayList<>();
        for (Parameter parameter : parameters) {
            int end = groups.size() - 1;
            if (end >= 0 && groups.get(end).isContinuedBy(parameter)) {
                groups.set(end, new ParameterGroup(groups.get(end).first(), parameter));
            } else {
                groups.add(new ParameterGroup(parameter, parameter));
            }
        }
        return groups;
    }

    private boolean isContinuedBy(Parameter next) {
        Matcher before = NUMBERED.matcher(last.name());
        Matcher after = NUMBERED.matcher(next.name());
        return before.matches()
                && after.matches()
                && before.group(1).equals(after.group(1))
                && Integer.parseInt(before.group(2)) + 1 == Integer.parseInt(after.group(2))
                && last.renamed(next.name()).equals(next);
    }

    /**
     * Returns the title of the group in lists.
     *
     * @return one name, or the first and the last: {@code sonar0 … sonar15}
     */
    public String name() {
        return first.equals(last) ? first.name() : first.name() + " … " + last.name();
    }
}
