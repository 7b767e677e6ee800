package majic.script.syntax;

import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/** Goes through all comparisons of a condition. */
public record EachComparison(Consumer<Condition.Comparison> task) implements Condition.Visitor<@Nullable Void> {
    @Override
    public @Nullable Void or(Condition.Or or) {
        or.left().accept(this);
        return or.right().accept(this);
    }

    @Override
    public @Nullable Void and(Condition.And and) {
        and.left().accept(this);
        return and.right().accept(this);
    }

    @Override
    public @Nullable Void not(Condition.Not not) {
        return not.inner().accept(this);
    }

    @Override
    public @Nullable Void comparison(Condition.Comparison comparison) {
        task.accept(comparison);
        return null;
    }

    @Override
    public @Nullable Void known(Condition.Known known) {
        return null;
    }
}
