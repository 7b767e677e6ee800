package majic.script.run;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.OptionalInt;
import majic.bot.Value;
import majic.script.conditions.Comparisons;
import majic.script.conditions.ConditionEvaluator;
import majic.script.conditions.Truth;
import majic.script.syntax.Condition;
import majic.script.syntax.Late;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.team.Answer;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * Runs the statements of a script one behind the other: repeats and chooses blocks, computes values, calls procedures,
 * and watches the conditions of {@code on}. Used by the thread of the script.
 */
final class Interpreter implements Statement.Visitor<@Nullable Void> {
    private static final int MOST_CALLS = 50;

    /** Blocks that run inside each other, those of the calls around them included: the stack has room for them. */
    private static final int MOST_BLOCKS = 500;

    /**
     * A round that moves no robot takes at least this long, so that an idle loop cannot keep the clock from going on.
     */
    private static final double SHORTEST_ROUND_S = 0.01;

    private final ScriptExecution script;
    private final List<Watch> watches = new ArrayList<>();
    private Scope<Value> scope;
    private int calls;
    private int blocks;
    private boolean inWatch;

    /** Begins with some names. */
    Interpreter(ScriptExecution script, Scope<Value> names) {
        this.script = script;
        this.scope = names;
    }

    /** The names that have values at present. */
    Scope<Value> scope() {
        return scope;
    }

    /** Whether a condition has to be looked at while the script waits. */
    boolean watches() {
        return !watches.isEmpty() && !inWatch;
    }

    /** Runs the statements of a file, which has names of its own. */
    void interpretFile(List<Statement> statements) {
        Scope<Value> caller = scope;
        scope = new Scope<>();
        try {
            interpret(statements);
        } finally {
            scope = caller;
        }
    }

    /** Runs statements one behind the other. */
    void interpret(List<Statement> statements) {
        for (Statement statement : statements) {
            script.checkAlive();
            runDueWatches();
            statement.accept(this);
        }
    }

    @Override
    public @Nullable Void repeat(Statement.Repeat repeat) {
        script.reach(repeat.at().line());
        OptionalInt times = repeat.times().with(values());
        for (int round = 0; times.isEmpty() || round < times.getAsInt(); round++) {
            if (round > 0) {
                script.reach(repeat.at().line());
            }
            round(repeat.body());
        }
        return null;
    }

    private LiveValues values() {
        return new LiveValues(script, true);
    }

    @Override
    public @Nullable Void whileLoop(Statement.While loop) {
        script.reach(loop.at().line());
        while (holds(loop.condition(), loop.at())) {
            round(loop.body());
            script.reach(loop.at().line());
        }
        return null;
    }

    @Override
    public @Nullable Void choice(Statement.If choice) {
        script.reach(choice.at().line());
        interpretBlock(holds(choice.condition(), choice.at()) ? choice.body() : choice.otherwise());
        return null;
    }

    @Override
    public @Nullable Void forRobots(Statement.ForRobots line) {
        script.reach(line.at().line());
        run(line);
        return null;
    }

    private void run(Statement.ForRobots line) {
        Command command = line.command();
        List<Member> robots = script.selection().members(line.robots());
        command.check(robots.stream()
                .map(robot -> new Command.Check(script.session(), script.selection(), robot, false, true))
                .toList());
        command.perform(script, robots);
    }

    @Override
    public @Nullable Void forSession(Statement.ForSession line) {
        script.reach(line.at().line());
        run(line);
        return null;
    }

    private void run(Statement.ForSession line) {
        SessionCommand command = line.command();
        command.check(new SessionCommand.Check(script.session(), script.selection(), false));
        command.run(script);
    }

    @Override
    public @Nullable Void argument(Statement.Argument argument) {
        scope.declare(argument.parameter().name(), argument.value());
        return null;
    }

    @Override
    public @Nullable Void computed(Statement.Computed line) {
        script.reach(line.at().line());
        Statement now = line.line().with(values());
        if (now instanceof Statement.ForRobots forRobots) {
            run(forRobots);
        } else if (now instanceof Statement.ForSession forSession) {
            run(forSession);
        } else if (now instanceof Statement.Call call) {
            run(call);
        }
        return null;
    }

    /** Reached again, in a loop or a procedure, a block takes the place of what it was before, with other names. */
    @Override
    public @Nullable Void on(Statement.On on) {
        script.reach(on.at().line());
        Watch watch = new Watch(on, scope);
        watches.stream().filter(before -> before.block == on).findFirst().ifPresent(before -> {
            watch.held = before.held;
            watches.remove(before);
        });
        watches.add(watch);
        return null;
    }

    @Override
    public @Nullable Void procedure(Statement.ProcedureDefinition definition) {
        return null;
    }

    @Override
    public @Nullable Void call(Statement.Call call) {
        script.reach(call.at().line());
        run(call);
        return null;
    }

    private void run(Statement.Call call) {
        if (calls == MOST_CALLS) {
            throw new ScriptException(
                    call.at(), call.at().text() + ": procedures call each other too deeply (" + MOST_CALLS + ")");
        }
        if (blocks >= MOST_BLOCKS) {
            throw new ScriptException(
                    call.at(),
                    call.at().text() + ": procedures call each other too deeply (" + MOST_BLOCKS + " blocks)");
        }
        Scope<Value> caller = scope;
        scope = caller.outermost().inner();
        for (int index = 0; index < call.given().size(); index++) {
            scope.declare(
                    call.procedure().arguments().get(index).text(),
                    call.given().get(index).computable());
        }
        calls++;
        try {
            interpret(call.procedure().body());
        } finally {
            calls--;
            scope = caller;
        }
    }

    /** Runs the statements of a block, whose own names end with it. */
    private void interpretBlock(List<Statement> body) {
        scope = scope.inner();
        blocks++;
        try {
            interpret(body);
        } finally {
            blocks--;
            scope = scope.around();
        }
    }

    /** A block that waits for its condition, with the names it knows. */
    private static final class Watch {
        private final Statement.On block;
        private final Scope<Value> scope;
        private boolean held;

        private Watch(Statement.On block, Scope<Value> scope) {
            this.block = block;
            this.scope = scope;
        }
    }

    /** Runs the blocks whose conditions have become true, unless one of them runs. */
    void runDueWatches() {
        if (inWatch || script.isOver()) {
            return;
        }
        inWatch = true;
        Scope<Value> interrupted = scope;
        try {
            for (Watch watch : List.copyOf(watches)) {
                scope = watch.scope;
                boolean holds = truth(watch.block.condition(), watch.block.at(), new LiveValues(script, false));
                boolean due = holds && !watch.held;
                watch.held = holds;
                if (due) {
                    interpretBlock(watch.block.body());
                }
            }
        } finally {
            scope = interrupted;
            inWatch = false;
        }
    }

    private void round(List<Statement> body) {
        long motionsBefore = script.motions();
        long began = script.time().nanos();
        interpretBlock(body);
        if (script.motions() == motionsBefore && script.time().secondsSince(began) < SHORTEST_ROUND_S) {
            script.pause(SHORTEST_ROUND_S);
        }
    }

    private boolean holds(Late<Condition> condition, Token at) {
        Collection<Member> asked =
                new ArrayList<>(ConditionEvaluator.allAsked(condition.sample(), script.selection(), null));
        script.awaitReadable(asked);
        return truth(condition, at, values());
    }

    private boolean truth(Late<Condition> written, Token at, LiveValues values) {
        Condition condition = written.with(values);
        Comparisons.check(condition, script.selection(), null);
        Truth truth = condition.accept(new ConditionEvaluator(script.selection(), null));
        if (truth.undecided() != null) {
            throw new ExecutionEnded(
                    Answer.Outcome.FAILED, at.text() + " " + condition + " is undecided: " + truth.undecided());
        }
        return truth.holds();
    }
}
