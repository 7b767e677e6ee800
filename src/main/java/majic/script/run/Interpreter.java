package majic.script.run;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import majic.script.conditions.Comparisons;
import majic.script.conditions.ConditionEvaluator;
import majic.script.conditions.Truth;
import majic.script.syntax.Condition;
import majic.script.syntax.Token;
import majic.team.Answer;
import majic.team.Member;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** Runs the statements of a script: checks each command when its turn comes, evaluates conditions, repeats blocks. */
final class Interpreter implements Statement.Visitor<@Nullable Void> {
    /**
     * A round that moves no robot takes at least this long, so that an idle loop cannot keep the clock from going on.
     */
    private static final double SHORTEST_ROUND_S = 0.01;

    private final ScriptExecution execution;
    private final TimeSource time;

    Interpreter(ScriptExecution execution) {
        this.execution = execution;
        this.time = execution.time();
    }

    /** Runs statements one behind the other. */
    void run(List<Statement> statements) {
        for (Statement statement : statements) {
            execution.checkAlive();
            statement.accept(this);
        }
    }

    @Override
    public @Nullable Void repeat(Statement.Repeat repeat) {
        for (int round = 0; repeat.times().isEmpty() || round < repeat.times().getAsInt(); round++) {
            execution.reach(repeat.at().line());
            round(repeat.body());
        }
        return null;
    }

    @Override
    public @Nullable Void whileLoop(Statement.While loop) {
        execution.reach(loop.at().line());
        while (holds(loop.condition(), loop.at())) {
            round(loop.body());
            execution.reach(loop.at().line());
        }
        return null;
    }

    @Override
    public @Nullable Void choice(Statement.If choice) {
        execution.reach(choice.at().line());
        run(holds(choice.condition(), choice.at()) ? choice.body() : choice.otherwise());
        return null;
    }

    @Override
    public @Nullable Void forRobots(Statement.ForRobots line) {
        execution.reach(line.at().line());
        Command command = line.command();
        List<Member> robots = execution.selection().members(line.robots());
        command.check(robots.stream()
                .map(robot -> new Command.Check(execution.session(), execution.selection(), robot, false, true))
                .toList());
        command.perform(execution, robots);
        return null;
    }

    @Override
    public @Nullable Void forSession(Statement.ForSession line) {
        execution.reach(line.at().line());
        SessionCommand command = line.command();
        command.check(new SessionCommand.Check(execution.session(), execution.selection(), false));
        command.run(execution);
        return null;
    }

    @Override
    public @Nullable Void argument(Statement.Argument argument) {
        return null;
    }

    private void round(List<Statement> body) {
        long motionsBefore = execution.motions();
        long began = time.nanos();
        run(body);
        if (execution.motions() == motionsBefore && time.secondsSince(began) < SHORTEST_ROUND_S) {
            execution.pause(SHORTEST_ROUND_S);
        }
    }

    private boolean holds(Condition condition, Token at) {
        Collection<Member> asked = new ArrayList<>(ConditionEvaluator.allAsked(condition, execution.selection(), null));
        execution.awaitReadable(asked);
        Comparisons.check(condition, execution.selection(), null);
        Truth truth = condition.accept(new ConditionEvaluator(execution.selection(), null));
        if (truth.undecided() != null) {
            throw new ExecutionEnded(
                    Answer.Outcome.FAILED, at.text() + " " + condition + " is undecided: " + truth.undecided());
        }
        return truth.holds();
    }
}
