package majic.script.commands;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.script.run.Execution;
import majic.script.run.Scheduling;
import majic.script.run.SessionCommand;
import majic.script.run.Types;
import majic.script.syntax.Literal;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import org.jspecify.annotations.Nullable;

/** The commands that keep values, show them, and ask for them. */
final class ValueCommands {
    private ValueCommands() {}

    /** A command that an act may contain as well. */
    private interface ValueCommand extends SessionCommand {
        @Override
        default Optional<String> refusalInAct() {
            return Optional.empty();
        }
    }

    private static Value assign(Execution execution, Token name, Value value) {
        Value kept = Types.kept(name, execution.scope().find(name.text()), value);
        execution.scope().assign(name.text(), kept);
        return kept;
    }

    /** Gives a name a value. */
    record Let(Token name, Value value) implements ValueCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.HOLDS;
        }

        /** At a prompt the value is shown. */
        @Override
        public void run(Execution execution) {
            Value kept = assign(execution, name, value);
            if (execution.isTyped()) {
                execution.answer(name.text() + " = " + kept);
            }
        }
    }

    /** Shows texts and values in one line. */
    record Print(List<Value> values) implements ValueCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.HOLDS;
        }

        @Override
        public void run(Execution execution) {
            execution.answer(values.stream().map(Value::toString).collect(Collectors.joining(" ")));
        }
    }

    /** Asks a person for a value and waits for the answer. */
    record Ask(
            Token name,
            Parameter wanted,
            Value otherwise,
            @Nullable Literal time) implements ValueCommand {
        private static final double USUAL_S = 60;

        @Override
        public Scheduling scheduling() {
            return Scheduling.HOLDS;
        }

        @Override
        public void check(Check check) {
            if (seconds() < 0) {
                throw new ScriptException(name, "ask: time does not run backward");
            }
        }

        private double seconds() {
            return time == null ? USUAL_S : time.number();
        }

        @Override
        public void run(Execution execution) {
            String question = wanted.help().isEmpty() ? name.text() + "?" : wanted.help();
            assign(execution, name, execution.ask(question, wanted, otherwise, seconds()));
        }
    }

    /** Answers the oldest question. */
    record Answer(Literal value) implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.ANSWERS;
        }

        @Override
        public void run(Execution execution) {
            value.at().check(() -> execution.session().questions().answer(value.value()));
        }
    }
}
