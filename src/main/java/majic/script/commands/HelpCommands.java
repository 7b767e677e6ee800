package majic.script.commands;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import majic.script.run.Command;
import majic.script.run.Execution;
import majic.script.run.Scheduling;
import majic.script.run.SessionCommand;
import majic.script.run.SessionState;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.team.Member;
import majic.text.Suggestion;
import org.jspecify.annotations.Nullable;

/** The commands that describe commands, and the one that ends MAJIC. */
final class HelpCommands {
    private HelpCommands() {}

    /** Lists the commands and parameters of robots, or describes one. */
    record RobotHelp(Token at, @Nullable Token topic) implements Command {
        @Override
        public Scheduling scheduling() {
            return Scheduling.OVERTAKES;
        }

        @Override
        public Optional<String> refusalInAct() {
            return Optional.of("an act needs none; leave the line out");
        }

        @Override
        public String text() {
            return topic == null ? "help" : "help " + topic.text();
        }

        @Override
        public void check(Check check) {
            if (topic != null && !Help.isCommand(topic.text(), check.bot())) {
                check.parameter(topic);
            }
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            robots.forEach(member -> Help.of(member, topic).forEach(execution::answer));
        }

        @Override
        public String replayText(Execution execution) {
            return "";
        }
    }

    /** Describes the language, or one word of it. */
    record LanguageHelp(@Nullable Token topic) implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.OVERTAKES;
        }

        @Override
        public void check(Check check) {
            if (topic != null && !Help.topics().contains(topic.text().toLowerCase(Locale.ROOT))) {
                String meant = Suggestion.didYouMean(topic.text(), Help.topics());
                throw new ScriptException(
                        topic,
                        topic.text() + ": no help on that"
                                + (meant.isEmpty() ? "; \"acts " + topic.text() + "\" describes an act" : meant));
            }
        }

        @Override
        public void run(Execution execution) {
            SessionState session = execution.session();
            Help.of(session.factory(), session.team(), topic).forEach(execution::answer);
        }
    }

    /** Ends MAJIC. */
    record Quit() implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.OVERTAKES;
        }

        @Override
        public void run(Execution execution) {
            execution.session().quit().run();
        }
    }
}
