package majic.stop;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import majic.bot.BotListener;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.environment.Settings;
import majic.program.Plugins;
import majic.simulation.SimulatedLab;
import majic.team.BotFactory;
import majic.team.Gate;
import majic.team.QueuedCommand;
import majic.team.Team;
import majic.team.TeamListener;
import majicsim.LabOptions;
import org.junit.jupiter.api.Test;

/**
 * Tests that STOP halts real drivers' robots although every listener blocks forever. The lab's clock follows the wall
 * clock here, at {@value #SPEED} times its speed: a stepped one would wait for the blocked threads.
 */
class BlockedListenersTest {
    private static final double SPEED = 20;

    private final Gate gate = Gate.closed();

    @Test
    void everyRobotOfTheLabIsStopped() throws IOException, InterruptedException {
        try (SimulatedLab lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), SPEED);
                Team team = new Team(lab.time())) {
            BotFactory factory = new BotFactory(Plugins.in(Path.of("none")).types(), Settings.inMemory());
            factory.useLab(lab);
            for (String robot : lab.robots()) {
                MajicBot bot = factory.create("sim:" + robot);
                bot.connect();
                team.add(bot, OptionalInt.empty());
            }
            Map<String, Pose> start = lab.truePoses();
            team.members()
                    .forEach(member -> member.submit(
                            new QueuedCommand(
                                    "drive 50 0 for 20s", true, bot -> List.of(bot.drive(50, 0, 20, Guard.NEVER) + "")),
                            null));
            while (!allMoved(start, lab.truePoses())) {
                lab.time().sleep(0.1);
            }
            team.members().forEach(member -> member.bot().addListener(gate.blocked(BotListener.class)));
            team.addListener(gate.blocked(TeamListener.class));
            lab.time().sleep(0.3);

            team.stopAll();

            lab.time().sleep(3);
            Map<String, Pose> stopped = lab.truePoses();
            lab.time().sleep(1);
            assertThat(lab.truePoses()).isEqualTo(stopped);
        } finally {
            gate.open();
        }
    }

    private static boolean allMoved(Map<String, Pose> start, Map<String, Pose> now) {
        return start.keySet().stream().allMatch(robot -> now.get(robot).distanceMm(start.get(robot)) > 20);
    }
}
