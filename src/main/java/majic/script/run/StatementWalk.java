package majic.script.run;

import java.util.ArrayDeque;
import java.util.HashSet;
import java.util.List;
import java.util.Queue;
import java.util.Set;
import majic.script.syntax.Condition;
import majic.script.syntax.Cursor;
import majic.script.syntax.Late;
import org.jspecify.annotations.Nullable;

/** Goes through all commands of a script, one behind the other, into every block. Runs none of them. */
public abstract class StatementWalk implements Statement.Visitor<@Nullable Void> {
    private final Set<Procedure> walked = new HashSet<>();
    private final Queue<Procedure> called = new ArrayDeque<>();
    private boolean walking;

    /** Goes through some statements. */
    public final void walk(List<Statement> statements) {
        boolean isOutermost = !walking;
        walking = true;
        statements.forEach(this::visit);
        while (isOutermost && !called.isEmpty()) {
            block(called.remove().body());
        }
        walking = !isOutermost;
    }

    /** Visits one statement and those in it; an override has to call this method. */
    public void visit(Statement statement) {
        statement.accept(this);
    }

    /** Looks at the condition that a block begins with; nothing unless overridden. */
    public void head(Late<Condition> condition) {}

    /** Looks at the readings in the values of a line or a condition; nothing unless overridden. */
    public void readings(List<Cursor.Reading> readings) {}

    /** Goes through the statements of a block. */
    void block(List<Statement> body) {
        walk(body);
    }

    @Override
    public @Nullable Void repeat(Statement.Repeat repeat) {
        readings(repeat.times().readings());
        block(repeat.body());
        return null;
    }

    @Override
    public final @Nullable Void whileLoop(Statement.While loop) {
        headed(loop.condition(), loop.body());
        return null;
    }

    @Override
    public final @Nullable Void choice(Statement.If choice) {
        headed(choice.condition(), choice.body());
        block(choice.otherwise());
        return null;
    }

    @Override
    public final @Nullable Void on(Statement.On on) {
        headed(on.condition(), on.body());
        return null;
    }

    private void headed(Late<Condition> condition, List<Statement> body) {
        readings(condition.readings());
        head(condition);
        block(body);
    }

    /** Goes through a line as far as it is known before it runs. */
    @Override
    public @Nullable Void computed(Statement.Computed line) {
        readings(line.line().readings());
        return line.line().sample().accept(this);
    }

    @Override
    public @Nullable Void procedure(Statement.ProcedureDefinition definition) {
        if (walked.add(definition.procedure())) {
            block(definition.procedure().body());
        }
        return null;
    }

    /** A procedure is gone through once, at the end: a chain of calls may be as long as the script. */
    @Override
    public @Nullable Void call(Statement.Call call) {
        if (walked.add(call.procedure())) {
            called.add(call.procedure());
        }
        return null;
    }

    @Override
    public @Nullable Void argument(Statement.Argument argument) {
        return null;
    }
}
