import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalInt;
import majic.act.ActRun;
import majic.act.Role;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.driver.Permit;
import majic.environment.Settings;
import majic.simulation.SimulatedLab;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;
import majicsim.LabOptions;
import org.junit.jupiter.api.Test;

/** Runs the act in the simulated lab, whose time passes as fast as the computer permits. */
class PacerTest {
    @Test
    void itGoesAwayAndComesBackWithoutABump() throws IOException {
        try (SimulatedLab lab = SimulatedLab.stepped(LabOptions.exactOnFreePorts());
                Team team = new Team(lab.time())) {
            lab.time().join();
            BotFactory factory =
                    new BotFactory(BotFactory.types(PacerTest.class.getClassLoader()), Settings.inMemory());
            factory.useLab(lab);
            MajicBot robot = factory.create("sim:pioneer");
            robot.connect();
            Member member = team.add(robot, OptionalInt.empty());
            Pose start = pose(lab);
            Farthest farthest = new Farthest();
            robot.addListener(farthest);

            new ActRun(new Pacer(), "Pacer", Map.of(Role.ME, List.of(member)), new Permit()).run(null);

            assertTrue(farthest.mm > 300, "it has gone " + farthest.mm + " mm");
            assertTrue(start.distanceMm(pose(lab)) < 100, "it is not back at " + start + " but at " + pose(lab));
            assertEquals(0, lab.simulators().bumps().get("pioneer"));
        }
    }

    private static Pose pose(SimulatedLab lab) {
        return Objects.requireNonNull(lab.truePoses().get("pioneer"));
    }

    /** How far the robot was from its start. */
    private static final class Farthest implements BotListener {
        private volatile double mm;

        @Override
        public void stateChanged(MajicBot robot, BotState state) {
            mm = Math.max(mm, state.pose().distanceMm(Pose.START));
        }
    }
}
