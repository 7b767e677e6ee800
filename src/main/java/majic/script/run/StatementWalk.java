package majic.script.run;

import java.util.List;
import majic.script.syntax.Condition;
import org.jspecify.annotations.Nullable;

/** Goes through all commands of a script, one behind the other, into every block. Runs none of them. */
public abstract class StatementWalk implements Statement.Visitor<@Nullable Void> {
    /** Goes through some statements. */
    public final void walk(List<Statement> statements) {
        statements.forEach(this::visit);
    }

    /** Visits one statement and those in it; an override has to call this method. */
    public void visit(Statement statement) {
        statement.accept(this);
    }

    /** Looks at what a block begins with; nothing unless overridden. */
    public void head(Condition condition) {}

    @Override
    public final @Nullable Void repeat(Statement.Repeat repeat) {
        walk(repeat.body());
        return null;
    }

    @Override
    public final @Nullable Void whileLoop(Statement.While loop) {
        head(loop.condition());
        walk(loop.body());
        return null;
    }

    @Override
    public final @Nullable Void choice(Statement.If choice) {
        head(choice.condition());
        walk(choice.body());
        walk(choice.otherwise());
        return null;
    }

    @Override
    public @Nullable Void argument(Statement.Argument argument) {
        return null;
    }
}
