package majic.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

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

/** A copter that is sent to places of the office by the planner of the team, lower than the tops of the walls. */
class CopterGoToInLabTest {
    private static final Path OFFICE = Path.of("sims", "worlds", "office.map");
    private static final Pose HOME = new Pose(-7000, -6000, 0);
    private static final int BRAKE = 17;

    /** Within this it arrives by its own position, which is that of the simulation here. */
    private static final double ARRIVED_MM = 200;

    @AutoClose
    private final LabRig rig = LabRig.of(office());

    private final MajicBot copter;

    CopterGoToInLabTest() throws InterruptedException {
        rig.lab().place("mavlink", HOME);
        copter = rig.add("mavlink");
        rig.lab().time().sleep(2);
        rig.run("map open " + OFFICE, "1 set pose -7000 -6000 0");
    }

    private static LabOptions office() {
        try {
            return LabOptions.exactOnFreePorts()
                    .withMavlink(MavlinkOptions.parse("copter+ready"))
                    .withRoom(Room.load(OFFICE));
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private void flying(int radiusMm) throws InterruptedException {
        List<String> answers = rig.run("1 set fence " + radiusMm + " 200 3000", "1 arm", "1 takeoff 700");
        assertThat(answers).anySatisfy(answer -> assertThat(answer).matches("1 takeoff 700: \\d+ mm above home"));
    }

    private String goTo(String place) throws InterruptedException {
        return String.join("\n", rig.run("1 goto " + place, "1 wait"));
    }

    private int mode() {
        int[] mode = new int[1];
        rig.lab().simulators().besideMavlink("mavlink", vehicle -> mode[0] = vehicle.mode());
        return mode[0];
    }

    private void assertNothingWasHit() {
        assertThat(rig.lab().bumps().values()).allMatch(bumps -> bumps == 0);
        rig.lab()
                .simulators()
                .besideMavlink(
                        "mavlink", vehicle -> assertThat(vehicle.crashes()).isZero());
    }

    @Test
    void itFliesAroundACorner() throws InterruptedException {
        flying(6000);

        assertThat(goTo("-5000 -3500")).contains("goto -5000 -3500: done");

        assertThat(rig.truePose("mavlink").distanceMm(new Pose(-5000, -3500, 0)))
                .isLessThan(ARRIVED_MM);
        assertThat(copter.heightMm().orElseThrow()).isBetween(400.0, 1000.0);
        assertNothingWasHit();
    }

    @Test
    void aPlaceOutsideOfTheFenceIsRefusedAtOnce() throws InterruptedException {
        flying(3000);

        assertThat(goTo("-5000 -3500"))
                .contains("-5000 -3500 is 3.2 m from home, outside of the fence of 3 m;"
                        + " \"set fence\" sets a larger one");
        assertThat(rig.truePose("mavlink").distanceMm(HOME)).isLessThan(100);
    }

    @Test
    void aWayThatLeavesTheFenceIsNotFlown() throws InterruptedException {
        flying(2100);

        assertThat(goTo("-6700 -4000")).contains("every way leaves the fence of 2.1 m");
        assertThat(rig.truePose("mavlink").distanceMm(HOME)).isLessThan(100);
    }

    @Test
    void homeStaysWhereItWasWhenThePoseIsCorrected() throws InterruptedException {
        flying(3000);
        rig.run("1 turn 90", "1 set pose 0 0 0");

        assertThat(copter.fence().orElseThrow().insideMm(0, 0)).isCloseTo(3000, within(150.0));
    }

    @Test
    void aStopLeavesItHoveringOnTheWay() throws InterruptedException {
        flying(12000);
        rig.say("1 goto 2000 -6000");
        rig.lab().time().sleep(6);

        rig.run("1 stop");

        assertThat(mode()).isEqualTo(BRAKE);
        Pose stopped = rig.truePose("mavlink");
        rig.lab().time().sleep(3);
        assertThat(rig.truePose("mavlink").distanceMm(stopped)).isLessThan(150);
        assertThat(stopped.distanceMm(HOME)).isGreaterThan(300);
        assertThat(rig.session().map().navigator().way(copter)).isEmpty();
        assertNothingWasHit();
    }

    @Test
    void aConditionEndsIt() throws InterruptedException {
        flying(12000);

        assertThat(String.join("\n", rig.run("1 goto 2000 -6000 until x > -6000", "1 wait")))
                .contains("x > -6000");
        assertThat(rig.truePose("mavlink").distanceMm(HOME)).isBetween(800.0, 2500.0);
    }

    @Test
    void actsForRobotsOnTheGroundDoNotTakeIt() throws InterruptedException {
        flying(6000);

        for (String act : List.of("GoTo x=-6500 y=-6000", "Patrol places=desk", "AiboSquare")) {
            assertThat(String.join("\n", rig.run("1 act " + act)))
                    .contains("leaves the ground, and the act is for robots on the ground");
        }
        assertThat(rig.truePose("mavlink").distanceMm(HOME)).isLessThan(100);
    }
}
