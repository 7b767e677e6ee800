package majic.script.actions;

import java.util.List;
import java.util.function.Function;
import majic.bot.BotException;
import majic.script.record.RecordedBlock;
import majic.script.record.SessionRecord;
import majic.script.run.ActRunner;
import majic.script.run.ActRunner.CheckedAct;
import majic.script.run.ActionLookup;
import majic.script.run.Execution;
import majic.script.run.RobotAction;
import majic.script.run.SessionAction;
import majic.script.syntax.Command;
import majic.script.syntax.Literal;
import majic.script.syntax.SessionCommand;
import majic.team.Member;
import majic.team.QueuedCommand;
import org.jspecify.annotations.Nullable;

/** The commands for behaviours and for the consent to their code. */
final class ActActions {
    private ActActions() {}

    static final class ActAction extends RobotAction {
        private final Command.Act act;
        private final ActRunner acts;
        private final ActionLookup actions;
        private @Nullable CheckedAct checked;

        ActAction(Command.Act act, ActRunner acts, ActionLookup actions) {
            super(act);
            this.act = act;
            this.acts = acts;
            this.actions = actions;
        }

        @Override
        public void check(Check check) {
            if (check.readsFiles()) {
                checkedAct().check(check);
            } else {
                check.selection().members(act.others());
            }
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            Function<Member, QueuedCommand> commands = checkedAct().commands(execution);
            execution.claim(execution.selection().members(act.others()));
            execution.submit(robots, commands);
        }

        /** Reads the file of the behaviour, once for the check, all robots and the run. */
        private CheckedAct checkedAct() {
            CheckedAct known = checked;
            if (known == null) {
                known = acts.read(act, actions);
                checked = known;
            }
            return known;
        }

        @Override
        public String replayText(boolean typed) {
            Literal name = act.name();
            Literal found = new Literal(name.at(), name.value(), acts.replayName(name));
            return new Command.Act(act.at(), found, act.arguments(), act.others()).text();
        }
    }

    static final class ActOffAction extends RobotAction {
        private final ActRunner acts;

        ActOffAction(Command.ActOff actOff, ActRunner acts) {
            super(actOff);
            this.acts = acts;
        }

        @Override
        public void check(Check check) {}

        @Override
        public void run(Execution execution, List<Member> robots) {
            execution.runToEnd(robots, acts::callOff);
        }

        @Override
        public void runRecorded(
                Execution execution, List<Member> robots, SessionRecord record, @Nullable RecordedBlock block) {
            long atNanos = record.nanos();
            run(execution, robots);
            record.calledOff(SessionRecord.numbers(robots), atNanos, block);
        }
    }

    /** Lists the behaviours, or describes one. */
    static final class ActsAction implements SessionAction {
        private final @Nullable Literal act;
        private final ActRunner acts;

        ActsAction(SessionCommand.Acts command, ActRunner acts) {
            this.act = command.act();
            this.acts = acts;
        }

        @Override
        public void check(Check check) {
            if (act != null) {
                act.at().check(() -> acts.describe(act.unquoted()));
            }
        }

        @Override
        public void run(Execution execution) {
            List<String> lines = act == null ? acts.list() : acts.describe(act.unquoted());
            lines.forEach(execution::answer);
        }
    }

    /** Lists the consents. Their files need not exist. */
    static final class ConsentsAction implements SessionAction {
        private final ActRunner acts;

        ConsentsAction(ActRunner acts) {
            this.acts = acts;
        }

        @Override
        public void check(Check check) {}

        @Override
        public void run(Execution execution) {
            acts.consents().forEach(execution::answer);
        }
    }

    static final class TrustAction implements SessionAction {
        private final SessionCommand.Trust trust;
        private final ActRunner acts;

        TrustAction(SessionCommand.Trust trust, ActRunner acts) {
            this.trust = trust;
            this.acts = acts;
        }

        @Override
        public void check(Check check) {
            trust.act().at().check(() -> acts.checkNamed(trust.act().unquoted()));
        }

        @Override
        public void run(Execution execution) {
            if (execution.isScript()) {
                throw new BotException("trust: only a person agrees to an act's code, not a script");
            }
            Literal hash = trust.hash();
            acts.trust(trust.act().unquoted(), hash == null ? "" : hash.unquoted())
                    .forEach(execution::answer);
        }
    }

    static final class TrustOffAction implements SessionAction {
        private final Literal fileOrHash;
        private final ActRunner acts;

        TrustOffAction(SessionCommand.TrustOff trustOff, ActRunner acts) {
            this.fileOrHash = trustOff.fileOrHash();
            this.acts = acts;
        }

        @Override
        public void check(Check check) {
            fileOrHash.at().check(() -> acts.checkHash(fileOrHash.unquoted()));
        }

        @Override
        public void run(Execution execution) {
            execution.answer(acts.trustOff(fileOrHash.unquoted()));
        }
    }
}
