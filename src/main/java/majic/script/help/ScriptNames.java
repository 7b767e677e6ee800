package majic.script.help;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;
import majic.script.commands.ScriptParser;
import majic.script.run.Procedures;
import majic.script.run.Scope;
import majic.script.run.Statement;
import majic.script.run.Types;
import majic.script.syntax.Operand;
import org.jspecify.annotations.Nullable;

/**
 * The names that a line of a script may use: the arguments, what the lines in front of it have given values to, and the
 * arguments of the procedure that it is in. The procedures are those of the whole script. Parsed when first needed.
 * Thread-safe.
 */
public final class ScriptNames implements VisibleNames {
    private final String script;
    private final int line;
    private final Supplier<Types> robots;
    private @Nullable Procedures procedures;
    private @Nullable Scope<Operand> kinds;
    private @Nullable List<Completion> values;

    /**
     * Parses nothing yet.
     *
     * @param line the number of the line, from 1
     * @param robots what is known of the robots, each time without names
     */
    public ScriptNames(String script, int line, Supplier<Types> robots) {
        this.script = script;
        this.line = line;
        this.robots = robots;
    }

    /** Returns whether these are the names of a line of a script. */
    public boolean isFor(String text, int number) {
        return number == line && text.equals(script);
    }

    @Override
    public synchronized Procedures procedures() {
        Procedures known = procedures;
        if (known == null) {
            known = new Procedures();
            ScriptParser.parse(script, List.of(), known, new Types(null), new ArrayList<>());
            procedures = known;
        }
        return known.copy();
    }

    /** A line that is wrong for the robots that are there is taken as if nothing were known of them. */
    @Override
    public synchronized Scope<Operand> kinds() {
        Scope<Operand> known = kinds;
        if (known == null) {
            known = behind(new Types(null));
            behind(robots.get()).all().forEach(known::declare);
            kinds = known;
        }
        return known.copy();
    }

    private Scope<Operand> behind(Types types) {
        return ScriptParser.namesBehind(before(), procedures(), types);
    }

    private String before() {
        int end = 0;
        for (int count = 1; count < line && end >= 0; count++) {
            end = script.indexOf('\n', end) + 1;
        }
        return script.substring(0, Math.max(0, end));
    }

    @Override
    public synchronized List<Completion> values() {
        List<Completion> known = values;
        if (known == null) {
            Map<String, Completion> arguments = arguments();
            List<Completion> all = new ArrayList<>();
            kinds().all()
                    .forEach((name, kind) -> all.add(arguments.getOrDefault(name, Explained.variable(name, kind))));
            known = List.copyOf(all);
            values = known;
        }
        return known;
    }

    private Map<String, Completion> arguments() {
        Map<String, Completion> arguments = new HashMap<>();
        for (Statement statement : ScriptParser.parse(before(), List.of(), new ArrayList<>())) {
            if (statement instanceof Statement.Argument argument) {
                arguments.put(
                        argument.parameter().name().toLowerCase(Locale.ROOT),
                        Explained.variable(argument.parameter(), argument.initial()));
            }
        }
        return arguments;
    }
}
