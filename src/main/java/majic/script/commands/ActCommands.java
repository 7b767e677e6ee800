package majic.script.commands;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import majic.bot.BotException;
import majic.script.record.RecordedBlock;
import majic.script.record.SessionRecord;
import majic.script.run.ActCall;
import majic.script.run.ActRunner;
import majic.script.run.Command;
import majic.script.run.CommandTrait;
import majic.script.run.Execution;
import majic.script.run.Scheduling;
import majic.script.run.SessionCommand;
import majic.script.syntax.Literal;
import majic.script.syntax.Robots;
import majic.script.syntax.Token;
import majic.team.Member;
import majic.team.QueuedCommand;
import org.jspecify.annotations.Nullable;

/** The commands for behaviours and for the consent to their code. */
final class ActCommands {
    private static final Optional<String> NO_OTHERS = Optional.of("an act does not run others");

    private ActCommands() {}

    /**
     * Runs a behaviour, with values for its arguments and the robots for its further roles. Used by one thread at a
     * time.
     */
    static final class Act implements Command {
        private final Token at;
        private final ActCall call;
        private ActRunner.@Nullable CheckedAct checked;

        Act(Token at, ActCall call) {
            this.at = at;
            this.call = call;
        }

        @Override
        public Token at() {
            return at;
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.COMMANDS_ROBOTS, CommandTrait.READS_FILES);
        }

        @Override
        public Optional<String> refusalInAct() {
            return NO_OTHERS;
        }

        @Override
        public @Nullable Robots others() {
            return call.others();
        }

        @Override
        public String text() {
            return call.text();
        }

        /** Reads the file of the behaviour anew, once for the check of all robots and the run after it. */
        @Override
        public void check(List<Check> robots) {
            checked = null;
            robots.forEach(this::check);
        }

        @Override
        public void check(Check check) {
            if (check.readsFiles()) {
                read(check.session().acts()).check(check);
            } else {
                check.selection().members(call.others());
            }
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            Function<Member, QueuedCommand> commands =
                    read(execution.session().acts()).commands(execution);
            execution.claim(execution.selection().members(call.others()));
            execution.submit(robots, commands);
        }

        private ActRunner.CheckedAct read(ActRunner acts) {
            ActRunner.CheckedAct known = checked;
            if (known == null) {
                known = acts.read(call);
                checked = known;
            }
            return known;
        }

        @Override
        public String replayText(Execution execution) {
            return call.text(execution.session().acts().replayName(call.name()));
        }
    }

    /** Ends the behaviour that a robot runs. */
    record ActOff(Token at) implements Command {
        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE_IF_TYPED;
        }

        @Override
        public Optional<String> refusalInAct() {
            return NO_OTHERS;
        }

        @Override
        public String text() {
            return "act off";
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            execution.runToEnd(robots, execution.session().acts()::callOff);
        }

        @Override
        public void runRecorded(
                Execution execution, List<Member> robots, SessionRecord record, @Nullable RecordedBlock block) {
            long atNanos = record.nanos();
            run(execution, robots);
            record.calledOff(SessionRecord.numbers(robots), atNanos, block);
        }
    }

    /** Lists the behaviours there are, or describes one. */
    record Acts(@Nullable Literal act) implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.READS_FILES);
        }

        @Override
        public void check(Check check) {
            if (act != null) {
                act.at().check(() -> check.session().acts().describe(act.unquoted()));
            }
        }

        @Override
        public void run(Execution execution) {
            ActRunner acts = execution.session().acts();
            List<String> lines = act == null ? acts.list() : acts.describe(act.unquoted());
            lines.forEach(execution::answer);
        }
    }

    /** Lists the files to whose code the user has agreed; they need not exist. */
    record Consents() implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.LOCAL_ONLY);
        }

        @Override
        public void run(Execution execution) {
            execution.session().acts().consents().forEach(execution::answer);
        }
    }

    /** Shows what a behaviour brings; with the beginning of its hash the user agrees to that. */
    record Trust(Literal act, @Nullable Literal hash) implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.READS_FILES, CommandTrait.CHANGES_TEAM, CommandTrait.LOCAL_ONLY);
        }

        @Override
        public void check(Check check) {
            act.at().check(() -> check.session().acts().checkNamed(act.unquoted()));
        }

        @Override
        public void run(Execution execution) {
            if (execution.isScript()) {
                throw new BotException("trust: only a person agrees to an act's code, not a script");
            }
            execution
                    .session()
                    .acts()
                    .trust(act.unquoted(), hash == null ? "" : hash.unquoted())
                    .forEach(execution::answer);
        }
    }

    /** Takes the consent to a file back; the file may be gone, and is named by its hash then. */
    record TrustOff(Literal fileOrHash) implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.READS_FILES, CommandTrait.CHANGES_TEAM, CommandTrait.LOCAL_ONLY);
        }

        @Override
        public void check(Check check) {
            fileOrHash.at().check(() -> check.session().acts().checkHash(fileOrHash.unquoted()));
        }

        @Override
        public void run(Execution execution) {
            execution.answer(execution.session().acts().trustOff(fileOrHash.unquoted()));
        }
    }
}
