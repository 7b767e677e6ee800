package majic.script.actions;

import java.util.List;
import java.util.Set;
import majic.script.record.RecordedBlock;
import majic.script.record.SessionRecord;
import majic.script.run.Execution;
import majic.script.run.RobotAction;
import majic.script.run.SessionAction;
import majic.script.syntax.Command;
import majic.script.syntax.SessionCommand;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/** The commands that hold the lines behind them. */
final class WaitActions {
    private WaitActions() {}

    /** Waits until some robots have finished. */
    static final class WaitForRobotsAction extends RobotAction {
        WaitForRobotsAction(Command.Await await) {
            super(await);
        }

        @Override
        public void check(Check check) {}

        @Override
        public void run(Execution execution, List<Member> robots) {
            execution.waits().awaitFinished(robots);
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
    static final class WaitForAllAction implements SessionAction {
        @Override
        public void check(Check check) {}

        @Override
        public void run(Execution execution) {
            execution.waits().awaitAll();
        }
    }

    /** Waits for a time. */
    static final class PauseAction implements SessionAction {
        private final double seconds;

        PauseAction(SessionCommand.Pause pause) {
            this.seconds = pause.time().value().number();
        }

        @Override
        public void check(Check check) {}

        @Override
        public void run(Execution execution) {
            execution.waits().pause(seconds);
        }
    }
}
