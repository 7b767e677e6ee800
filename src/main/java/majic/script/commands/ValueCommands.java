package majic.script.commands;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.script.run.Execution;
import majic.script.run.Scheduling;
import majic.script.run.SessionCommand;
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

    /** Gives a name a value. */
    record Let(Token name, Value value) implements ValueCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.HOLDS;
        }

        /** At a prompt the value is shown. */
        @Override
        public void run(Execution execution) {
            execution.scope().assign(name.text(), value);
            if (execution.isTyped()) {
                execution.answer(name.text() + " = " + value);
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
            execution.scope().assign(name.text(), execution.ask(question, wanted, otherwise, seconds()));
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
