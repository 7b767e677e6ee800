package majic.script.commands;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import majic.script.record.RecordedBlock;
import majic.script.record.SessionRecord;
import majic.script.run.Command;
import majic.script.run.Execution;
import majic.script.run.Scheduling;
import majic.script.run.SessionCommand;
import majic.script.syntax.Literal;
import majic.script.syntax.Token;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/** The commands that hold the lines behind them. */
final class WaitCommands {
    private WaitCommands() {}

    /** Waits until some robots have finished. */
    record AwaitRobots(Token at) implements Command {
        @Override
        public Scheduling scheduling() {
            return Scheduling.HOLDS;
        }

        @Override
        public String text() {
            return "wait";
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            execution.awaitFinished(robots);
        }

        /** Is recorded with the time at which the robots had finished. */
        @Override
        public void runRecorded(
                Execution execution, List<Member> robots, SessionRecord record, @Nullable RecordedBlock block) {
            run(execution, robots);
            Set<Integer> numbers = SessionRecord.numbers(robots);
            record.waited(SessionRecord.names(numbers) + " " + text(), numbers, block);
        }
    }

    /** Waits until all robots of a line or script have finished. */
    record AwaitAll() implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.HOLDS;
        }

        @Override
        public Optional<String> refusalInAct() {
            return Optional.empty();
        }

        @Override
        public void run(Execution execution) {
            execution.awaitAll();
        }
    }

    /** Lets time pass. */
    record Pause(Literal time) implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.HOLDS;
        }

        @Override
        public Optional<String> refusalInAct() {
            return Optional.empty();
        }

        @Override
        public void run(Execution execution) {
            execution.pause(time.number());
        }
    }
}
