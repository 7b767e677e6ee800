package majic.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.inlab.LabRig;
import majicsim.LabOptions;
import majicsim.mavlink.MavlinkOptions;
import majicsim.world.Room;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** A rover that is sent to places of the office by the planner of the team, beside a Pioneer. */
class RoverGoToInLabTest {
    private static final Path OFFICE = Path.of("sims", "worlds", "office.map");
    private static final int HOLD = 4;

    @AutoClose
    private final LabRig rig = LabRig.of(office());

    private final MajicBot rover;

    RoverGoToInLabTest() throws InterruptedException {
        rig.add("pioneer");
        rig.lab().place("mavlink", new Pose(-7000, -6000, 0));
        rover = rig.add("mavlink");
        rig.run("map open " + OFFICE, "2 arm", "2 set pose -7000 -6000 0");
    }

    private static LabOptions office() {
        try {
            return LabOptions.exactOnFreePorts()
                    .withMavlink(MavlinkOptions.parse("rover+ready"))
                    .withRoom(Room.load(OFFICE));
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private int mode() {
        int[] mode = new int[1];
        rig.lab().simulators().besideMavlink("mavlink", vehicle -> mode[0] = vehicle.mode());
        return mode[0];
    }

    @Test
    void itDrivesAroundACorner() throws InterruptedException {
        List<String> answers = rig.run("2 goto -5000 -3500", "2 wait");

        assertThat(answers).anySatisfy(answer -> assertThat(answer).contains("goto -5000 -3500: done"));
        assertThat(rig.truePose("mavlink").distanceMm(new Pose(-5000, -3500, 0)))
                .isLessThan(350);
        assertThat(rig.lab().bumps().values().stream()
                        .mapToInt(Integer::intValue)
                        .sum())
                .isZero();
    }

    @Test
    void aStopHoldsItOnTheWay() throws InterruptedException {
        rig.say("2 goto 5000 -6000");
        rig.lab().time().sleep(6);
        Pose before = rig.truePose("mavlink");
        rig.run("2 stop");

        assertThat(mode()).isEqualTo(HOLD);
        rig.lab().time().sleep(2);
        Pose stood = rig.truePose("mavlink");
        rig.lab().time().sleep(3);
        assertThat(rig.truePose("mavlink").distanceMm(stood)).isLessThan(5);
        assertThat(before.xMm()).isGreaterThan(-6800);
        assertThat(stood.distanceMm(before)).isLessThan(800);
        assertThat(rig.session().map().navigator().way(rover)).isEmpty();
    }

    @Test
    void itsGuardStopsItInFrontOfAWall() throws InterruptedException {
        rig.run("2 set guard on");

        String answer = rig.run("2 turn -90", "2 move 3000").get(1);

        assertThat(answer).doesNotContain("done (3000");
        assertThat(rig.lab().bumps().values().stream()
                        .mapToInt(Integer::intValue)
                        .sum())
                .isZero();
    }
}
