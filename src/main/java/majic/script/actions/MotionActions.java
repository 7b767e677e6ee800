package majic.script.actions;

import java.util.List;
import majic.bot.BotControl;
import majic.bot.Guard;
import majic.script.conditions.UntilGuard;
import majic.script.record.RecordedBlock;
import majic.script.record.SessionRecord;
import majic.script.run.Execution;
import majic.script.run.RobotAction;
import majic.script.syntax.Command;
import majic.script.syntax.Condition;
import majic.script.syntax.Literal;
import majic.team.Member;
import majic.team.QueuedCommand;
import org.jspecify.annotations.Nullable;

/** The commands that move a robot, and the one that stops it. */
final class MotionActions {
    private MotionActions() {}

    /** A motion in the robot's queue, until a condition if there is one. */
    private abstract static class MotionAction extends RobotAction {
        private final @Nullable Condition until;

        MotionAction(Command command) {
            super(command);
            this.until = command.until();
        }

        /** Moves the robot and returns what the answer shows in brackets. */
        abstract Object move(BotControl robot, Guard until);

        @Override
        public final void run(Execution execution, List<Member> robots) {
            execution.submit(robots, member -> command(member, execution));
        }

        private QueuedCommand command(Member member, Execution execution) {
            Guard guard = until == null ? Guard.NEVER : new UntilGuard(until, execution.selection(), member);
            return new QueuedCommand(text(), true, robot -> List.of(text() + ": done (" + move(robot, guard) + ")"));
        }

        final void checkUntil(Check check) {
            check.until(until);
        }
    }

    static final class MoveAction extends MotionAction {
        private final Literal distance;

        MoveAction(Command.Move move) {
            super(move);
            this.distance = move.distance();
        }

        @Override
        public void check(Check check) {
            checkUntil(check);
            if (!check.limitMayChange()) {
                distance.at().check(() -> check.bot().checkMove(number(distance)));
            }
        }

        @Override
        Object move(BotControl robot, Guard until) {
            return robot.move(number(distance), until);
        }
    }

    static final class TurnAction extends MotionAction {
        private final Literal angle;

        TurnAction(Command.Turn turn) {
            super(turn);
            this.angle = turn.angle();
        }

        @Override
        public void check(Check check) {
            angle.at().check(() -> check.bot().checkTurn(number(angle)));
            checkUntil(check);
        }

        @Override
        Object move(BotControl robot, Guard until) {
            return robot.turn(number(angle), until);
        }
    }

    static final class DriveAction extends MotionAction {
        /** How long a drive takes without a time, seconds. */
        private static final double DRIVE_S = 1;

        /** How long a drive lasts at most if its condition does not come true, seconds: the most a robot accepts. */
        private static final double LONGEST_DRIVE_S = 60;

        private final Command.Drive drive;

        DriveAction(Command.Drive drive) {
            super(drive);
            this.drive = drive;
        }

        @Override
        public void check(Check check) {
            double seconds = drive.seconds().orElse(DRIVE_S);
            drive.speed()
                    .at()
                    .check(() -> check.bot().checkDrive(number(drive.speed()), number(drive.rate()), seconds));
            checkUntil(check);
        }

        @Override
        Object move(BotControl robot, Guard until) {
            double seconds = drive.seconds().orElse(drive.until() == null ? DRIVE_S : LONGEST_DRIVE_S);
            return robot.drive(number(drive.speed()), number(drive.rate()), seconds, until);
        }
    }

    static final class StopAction extends RobotAction {
        StopAction(Command.Stop stop) {
            super(stop);
        }

        @Override
        public void check(Check check) {}

        @Override
        public void run(Execution execution, List<Member> robots) {
            execution.stop(robots);
        }

        /** Is recorded here only in a script; the team reports the stop of a line to the record. */
        @Override
        public void runRecorded(
                Execution execution, List<Member> robots, SessionRecord record, @Nullable RecordedBlock block) {
            long atNanos = record.nanos();
            run(execution, robots);
            if (execution.isScript()) {
                record.stopped(SessionRecord.numbers(robots), atNanos, block);
            }
        }
    }

    private static double number(Literal literal) {
        return literal.value().number();
    }
}
