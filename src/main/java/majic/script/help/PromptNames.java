package majic.script.help;

import java.util.List;
import majic.bot.Value;
import majic.script.run.Procedures;
import majic.script.run.Scope;
import majic.script.syntax.Operand;

/**
 * The names that the next line of a prompt may use.
 *
 * @param known what is known of them, in a scope of their own
 * @param present the values that they have now; a name may have none yet
 * @param callable the procedures, in a collection of their own
 */
public record PromptNames(Scope<Operand> known, Scope<Value> present, Procedures callable) implements VisibleNames {
    @Override
    public List<Completion> values() {
        return known.all().entrySet().stream()
                .map(entry -> {
                    Value value = present.find(entry.getKey());
                    return value == null
                            ? Explained.variable(entry.getKey(), entry.getValue())
                            : new Completion("$" + entry.getKey(), value.toString(), "");
                })
                .toList();
    }

    @Override
    public Scope<Operand> kinds() {
        return known.copy();
    }

    @Override
    public Procedures procedures() {
        return callable.copy();
    }
}
