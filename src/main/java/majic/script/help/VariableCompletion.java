package majic.script.help;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.script.commands.ScriptParser;
import majic.script.run.Statement;

/** Completes the names that stand for the values of a script's arguments, such as {@code $speed}. */
public final class VariableCompletion {
    private static final Pattern BEGUN = Pattern.compile("\\$[\\p{L}\\d_]*$");

    private VariableCompletion() {}

    /**
     * Completes the name in front of a place.
     *
     * @param script the whole script; only the arguments that it declares are used
     * @param typed the line up to that place
     * @return empty if no such name ends there
     */
    public static Optional<Completions> complete(String script, String typed) {
        Matcher begun = BEGUN.matcher(typed);
        return begun.find()
                ? Optional.of(new Completions(begun.start(), names(script, begun.group())))
                : Optional.empty();
    }

    private static List<Completion> names(String script, String begun) {
        return ScriptParser.parse(script, List.of(), Map.of(), new ArrayList<>()).stream()
                .filter(Statement.Argument.class::isInstance)
                .map(Statement.Argument.class::cast)
                .map(argument -> Explained.variable(argument.parameter(), argument.initial()))
                .filter(entry -> entry.text().toLowerCase(Locale.ROOT).startsWith(begun.toLowerCase(Locale.ROOT)))
                .toList();
    }
}
