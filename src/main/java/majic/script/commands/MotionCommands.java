package majic.script.commands;

import java.math.BigDecimal;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import majic.bot.BotControl;
import majic.bot.Guard;
import majic.bot.Pose;
import majic.nav.CurrentMap;
import majic.nav.Destination;
import majic.script.conditions.UntilGuard;
import majic.script.record.RecordedBlock;
import majic.script.record.SessionRecord;
import majic.script.run.Command;
import majic.script.run.CommandTrait;
import majic.script.run.Execution;
import majic.script.run.Scheduling;
import majic.script.syntax.Condition;
import majic.script.syntax.Literal;
import majic.script.syntax.Token;
import majic.team.Member;
import majic.team.QueuedCommand;
import org.jspecify.annotations.Nullable;

/** The commands that move a robot, and the one that stops it. */
final class MotionCommands {
    private MotionCommands() {}

    /** A motion in the robot's queue, until a condition if there is one. */
    private interface MotionCommand extends Command {
        /** Moves the robot of a member and returns what the answer shows in brackets. */
        Object move(Execution execution, Member member, BotControl robot, Guard until);

        @Override
        default Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        default List<CommandTrait> traits() {
            return List.of(CommandTrait.COMMANDS_ROBOTS);
        }

        @Override
        default void run(Execution execution, List<Member> robots) {
            String text = text();
            execution.submit(robots, member -> {
                Guard guard = until() == null ? Guard.NEVER : new UntilGuard(until(), execution.selection(), member);
                return new QueuedCommand(
                        text, true, robot -> List.of(text + ": done (" + move(execution, member, robot, guard) + ")"));
            });
        }
    }

    /** Drives straight. */
    record Move(Token at, Literal distance, @Nullable Condition until) implements MotionCommand {
        @Override
        public String text() {
            return "move " + distance.text() + untilText(until);
        }

        @Override
        public void check(Check check) {
            check.until(until);
            if (!check.limitMayChange()) {
                distance.at().check(() -> check.bot().checkMove(distance.number()));
            }
        }

        @Override
        public Object move(Execution execution, Member member, BotControl robot, Guard guard) {
            return robot.move(distance.number(), guard);
        }
    }

    /** Turns on the spot. */
    record Turn(Token at, Literal angle, @Nullable Condition until) implements MotionCommand {
        @Override
        public String text() {
            return "turn " + angle.text() + untilText(until);
        }

        @Override
        public void check(Check check) {
            angle.at().check(() -> check.bot().checkTurn(angle.number()));
            check.until(until);
        }

        @Override
        public Object move(Execution execution, Member member, BotControl robot, Guard guard) {
            return robot.turn(angle.number(), guard);
        }
    }

    /** Drives a curve; seconds are missing where none were written. */
    record Drive(
            Token at,
            Literal speed,
            Literal rate,
            OptionalDouble seconds,
            @Nullable Condition until) implements MotionCommand {
        /** How long a drive takes without a time, seconds. */
        private static final double DRIVE_S = 1;

        /** How long a drive lasts at most if its condition does not come true, seconds: the most a robot accepts. */
        private static final double LONGEST_DRIVE_S = 60;

        @Override
        public String text() {
            String speeds = "drive " + speed.text() + " " + rate.text();
            return seconds.isPresent()
                    ? speeds + " for " + inFull(seconds.getAsDouble()) + "s"
                    : speeds + untilText(until);
        }

        /** In full: a rounded time would drive further. */
        private static String inFull(double seconds) {
            return BigDecimal.valueOf(seconds).stripTrailingZeros().toPlainString();
        }

        @Override
        public void check(Check check) {
            double time = seconds.orElse(DRIVE_S);
            speed.at().check(() -> check.bot().checkDrive(speed.number(), rate.number(), time));
            check.until(until);
        }

        @Override
        public Object move(Execution execution, Member member, BotControl robot, Guard guard) {
            double time = seconds.orElse(until == null ? DRIVE_S : LONGEST_DRIVE_S);
            return robot.drive(speed.number(), rate.number(), time, guard);
        }
    }

    /** Drives to a place: one of the map by its name, or coordinates. */
    record GoTo(
            Token at,
            @Nullable Token place,
            List<Literal> coordinates,
            @Nullable Condition until) implements Command {
        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.COMMANDS_ROBOTS);
        }

        @Override
        public String text() {
            String where = place == null
                    ? coordinates.stream().map(Literal::text).collect(Collectors.joining(" "))
                    : place.text();
            return "goto " + where + untilText(until);
        }

        @Override
        public void check(Check check) {
            check.until(until);
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            CurrentMap map = execution.session().map();
            Destination destination = destination(map);
            String text = text();
            execution.submit(robots, member -> {
                Guard guard = until == null ? Guard.NEVER : new UntilGuard(until, execution.selection(), member);
                return new QueuedCommand(
                        text,
                        true,
                        robot -> List.of(text + ": done ("
                                + map.navigator().goTo(member.bot(), robot, destination, guard) + ")"));
            });
        }

        private Destination destination(CurrentMap map) {
            if (place != null) {
                return new Destination(map.place(place.text()));
            }
            boolean withHeading = coordinates.size() > 2;
            return new Destination(
                    new Pose(
                            coordinates.get(0).number(),
                            coordinates.get(1).number(),
                            withHeading ? coordinates.get(2).number() : 0),
                    withHeading);
        }
    }

    /** Drives where the map that the robot builds is unknown, until nothing is left. */
    record Explore(Token at, @Nullable Condition until) implements MotionCommand {
        @Override
        public String text() {
            return "explore" + untilText(until);
        }

        @Override
        public void check(Check check) {
            check.until(until);
        }

        @Override
        public Object move(Execution execution, Member member, BotControl robot, Guard guard) {
            return execution.session().map().explore(member.bot(), robot, guard);
        }
    }

    /** Stops the robots. */
    record Stop(Token at) implements Command {
        @Override
        public Scheduling scheduling() {
            return Scheduling.STOP;
        }

        @Override
        public String text() {
            return "stop";
        }

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

    private static String untilText(@Nullable Condition condition) {
        return condition == null ? "" : " until " + condition;
    }
}
