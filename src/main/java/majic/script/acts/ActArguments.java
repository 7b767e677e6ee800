package majic.script.acts;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import majic.act.ActArgument;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.script.run.ActCall;
import majic.script.syntax.Literal;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;

/** Checks the values that a line gives to the arguments of a behaviour. */
public final class ActArguments {
    private ActArguments() {}

    /**
     * Finds the argument of each value.
     *
     * @param known the arguments that the behaviour takes
     * @param given what the line gives
     * @return the values in the form that their arguments take, by name, in the order of the line
     * @throws ScriptException at the name or value that is wrong, with what would be right
     */
    public static Map<String, Value> fit(List<ActArgument> known, List<ActCall.Given> given) {
        Map<String, Value> values = new LinkedHashMap<>();
        Set<String> names = new HashSet<>();
        for (ActCall.Given one : given) {
            Token name = one.name();
            if (!names.add(name.text().toLowerCase(Locale.ROOT))) {
                throw new ScriptException(name, name.text() + ": given twice");
            }
            ActArgument argument = known.stream()
                    .filter(its -> its.isNamed(name.text()))
                    .findFirst()
                    .orElseThrow(() -> new ScriptException(name, ActArgument.unknown(name.text(), known)));
            values.put(argument.name(), one.value().at().resolve(() -> fit(argument.parameter(), one.value())));
        }
        return values;
    }

    /** A text keeps the characters as they were written, even if they look like a number. */
    private static Value fit(Parameter parameter, Literal given) {
        return parameter.fit(
                parameter.kind() == Parameter.Kind.TEXT ? Value.text(given.unquoted()) : given.valueFor(parameter));
    }
}
