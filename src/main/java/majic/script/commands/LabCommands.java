package majic.script.commands;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import majic.bot.BotException;
import majic.bot.Pose;
import majic.lab.LabAccess;
import majic.script.run.Command;
import majic.script.run.CommandTrait;
import majic.script.run.Execution;
import majic.script.run.Scheduling;
import majic.script.run.SessionCommand;
import majic.script.syntax.Literal;
import majic.script.syntax.Token;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.QueuedCommand;

/** The commands for the simulated lab. */
final class LabCommands {
    private LabCommands() {}

    /** Lists where the robots truly are, and how often each has run into something. */
    record Lab() implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public void check(Check check) {
            requireLab(check.session().factory());
        }

        @Override
        public void run(Execution execution) {
            LabAccess lab = requireLab(execution.session().factory());
            Map<String, Integer> bumps = lab.bumps();
            lab.truePoses()
                    .forEach((robot, pose) -> execution.answer(
                            "lab: " + robot + " " + text(pose) + " bumps=" + bumps.getOrDefault(robot, 0)));
        }

        private static String text(Pose pose) {
            double heading = Math.round(pose.headingDeg() * 10) / 10.0;
            return String.format(
                    Locale.ROOT, "x=%d y=%d heading=%.1f", Math.round(pose.xMm()), Math.round(pose.yMm()), heading);
        }
    }

    /**
     * Lifts a robot of the lab and puts it down at a pose in the room's frame, in its turn. From then on the robot
     * reports the pose at which it was put down, unless it was carried away: then nothing tells it.
     */
    record Place(Token at, Literal x, Literal y, Literal heading) implements Command {
        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.COMMANDS_ROBOTS);
        }

        @Override
        public Optional<String> refusalInAct() {
            return SessionCommand.REFUSED_IN_ACT;
        }

        @Override
        public String text() {
            return verb() + pose();
        }

        private boolean isCarried() {
            return at.is("carry");
        }

        private String verb() {
            return isCarried() ? "lab carry " : "lab place ";
        }

        /** The pose, as a line has it behind the robots. */
        private String pose() {
            return x.text() + " " + y.text() + " " + heading.text();
        }

        @Override
        public void check(Check check) {
            at.check(() -> {
                BotFactory factory = check.session().factory();
                LabAccess lab = requireLab(factory);
                if (factory.nameInLab(check.bot()).isEmpty() || check.bot().time() != lab.time()) {
                    throw new BotException(verb().trim() + ": robot "
                            + check.robot().number()
                            + " is not in the simulated lab; \"" + check.robot().number()
                            + " set pose\" sets the pose that a real robot reports");
                }
            });
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            execution.submit(
                    robots, member -> command(member, execution.session().factory()));
        }

        private QueuedCommand command(Member member, BotFactory factory) {
            String robot = factory.nameInLab(member.bot()).orElseThrow();
            Pose pose = new Pose(x.number(), y.number(), heading.number());
            return new QueuedCommand(text(), false, control -> {
                requireLab(factory).place(robot, pose);
                if (!isCarried()) {
                    member.bot().place(pose);
                }
                return List.of(text() + ": done");
            });
        }

        @Override
        public String replayLine(Execution execution, String robots) {
            return verb() + robots + " " + pose();
        }
    }

    private static LabAccess requireLab(BotFactory factory) {
        return factory.lab()
                .orElseThrow(() -> new BotException("lab: no simulated lab runs here; start MAJIC with --lab"));
    }
}
