package majic.script.actions;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import majic.bot.BotException;
import majic.bot.Pose;
import majic.lab.LabAccess;
import majic.script.run.Execution;
import majic.script.run.RobotAction;
import majic.script.run.SessionAction;
import majic.script.syntax.Command;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.QueuedCommand;

/** The commands for the simulated lab. */
final class LabActions {
    private LabActions() {}

    /** Lists where the robots truly are, and how often each has run into something. */
    static final class LabAction implements SessionAction {
        private final BotFactory factory;

        LabAction(BotFactory factory) {
            this.factory = factory;
        }

        @Override
        public void check(Check check) {
            requireLab(factory);
        }

        @Override
        public void run(Execution execution) {
            LabAccess lab = requireLab(factory);
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
     * Lifts a robot of the lab and puts it down elsewhere, in its turn. From then on the robot reports the pose at
     * which it was put down.
     */
    static final class PlaceAction extends RobotAction {
        private final Command.Place place;
        private final BotFactory factory;

        PlaceAction(Command.Place place, BotFactory factory) {
            super(place);
            this.place = place;
            this.factory = factory;
        }

        @Override
        public void check(Check check) {
            place.at().check(() -> {
                LabAccess lab = requireLab(factory);
                if (factory.nameInLab(check.bot()).isEmpty() || check.bot().time() != lab.time()) {
                    throw new BotException("lab place: robot " + check.robot().number()
                            + " is not in the simulated lab; \"" + check.robot().number()
                            + " set pose\" sets the pose that a real robot reports");
                }
            });
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            execution.submit(robots, this::command);
        }

        private QueuedCommand command(Member member) {
            String robot = factory.nameInLab(member.bot()).orElseThrow();
            Pose pose = new Pose(
                    place.x().value().number(),
                    place.y().value().number(),
                    place.heading().value().number());
            return new QueuedCommand(text(), false, control -> {
                requireLab(factory).place(robot, pose);
                member.bot().place(pose);
                return List.of(text() + ": done");
            });
        }

        @Override
        public String replayLine(String robots, boolean typed) {
            return "lab place " + robots + " " + place.pose();
        }
    }

    private static LabAccess requireLab(BotFactory factory) {
        return factory.lab()
                .orElseThrow(() -> new BotException("lab: no simulated lab runs here; start MAJIC with --lab"));
    }
}
