package majic.script.actions;

import java.util.List;
import java.util.Locale;
import majic.script.help.Help;
import majic.script.run.Execution;
import majic.script.run.RobotAction;
import majic.script.run.SessionAction;
import majic.script.syntax.Command;
import majic.script.syntax.ScriptException;
import majic.script.syntax.SessionCommand;
import majic.script.syntax.Token;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;
import majic.text.Suggestion;
import org.jspecify.annotations.Nullable;

/** The commands that describe commands, and the one that ends MAJIC. */
final class HelpActions {
    private HelpActions() {}

    /** Describes the commands and parameters of robots. */
    static final class RobotHelpAction extends RobotAction {
        private final @Nullable Token topic;

        RobotHelpAction(Command.Help help) {
            super(help);
            this.topic = help.parameter();
        }

        @Override
        public void check(Check check) {
            if (topic != null && !check.isCommand(topic.text())) {
                check.parameter(topic);
            }
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            robots.forEach(member -> Help.of(member, topic).forEach(execution::answer));
        }

        @Override
        public String replayText(boolean typed) {
            return "";
        }
    }

    /** Describes the language. */
    static final class LanguageHelpAction implements SessionAction {
        private final @Nullable Token topic;
        private final BotFactory factory;
        private final Team team;

        LanguageHelpAction(SessionCommand.Help help, BotFactory factory, Team team) {
            this.topic = help.topic();
            this.factory = factory;
            this.team = team;
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
            Help.of(factory, team, topic).forEach(execution::answer);
        }
    }

    static final class QuitAction implements SessionAction {
        private final Runnable quit;

        QuitAction(Runnable quit) {
            this.quit = quit;
        }

        @Override
        public void check(Check check) {}

        @Override
        public void run(Execution execution) {
            quit.run();
        }
    }
}
