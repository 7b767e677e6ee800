package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.BooleanSupplier;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.bot.Uncertainty;
import majic.team.ManualControl;
import majicsim.LabOptions;
import majicsim.world.Room;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A Pioneer that is driven at a wall of the office. */
class GuardedDrivingInLabTest {
    private static final Path OFFICE = Path.of("sims", "worlds", "office.map");
    private static final double FAST = 400;
    private static final Pose START = new Pose(-7000, -6500, 90);
    private static final String SEEN = "something that its sensors see is \\d+ mm ahead";

    @AutoClose
    private final LabRig rig = LabRig.of(office());

    private final MajicBot robot = rig.add("pioneer");

    GuardedDrivingInLabTest() throws InterruptedException {
        rig.run("lab place 1 -7000 -6500 90", "1 set guard on");
    }

    private static LabOptions office() {
        try {
            return LabOptions.exactOnFreePorts().withRoom(Room.load(OFFICE));
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private int contacts() {
        return rig.lab().bumps().values().stream().mapToInt(Integer::intValue).sum();
    }

    private String answer(String line) throws InterruptedException {
        List<String> said = rig.run(line);
        return said.get(said.size() - 1);
    }

    /** Renews a drive as a held key does, until a condition is true or 20 s have passed. */
    private void hold(ManualControl hand, double mmPerSec, BooleanSupplier until) throws InterruptedException {
        for (int renewal = 0; renewal < 200 && !until.getAsBoolean(); renewal++) {
            hand.drive(mmPerSec, 0, true);
            rig.lab().time().sleep(0.1);
        }
    }

    @Test
    void aMoveStopsInFrontOfTheWallAndFails() throws InterruptedException {
        assertThat(answer("1 move 5000")).matches("1 move 5000: failed: stopped after [\\d.]+ mm: " + SEEN);
        assertThat(contacts()).isZero();
        assertThat(robot.get("distanceFront").number()).isBetween(60.0, 400.0);
    }

    @Test
    void aMoveThatHasRoomIsDone() throws InterruptedException {
        assertThat(answer("1 move 300")).contains("move 300: done (");
        assertThat(answer("1 turn 90")).contains("turn 90: done (");
    }

    @Test
    void aDriveForATimeSlowsDownAndFails() throws InterruptedException {
        assertThat(answer("1 drive 400 0 for 30s"))
                .matches("1 drive 400 0 for 30s: failed: stopped after \\d+ mm: " + SEEN);
        assertThat(contacts()).isZero();
        assertThat(robot.get("distanceFront").number()).isBetween(60.0, 250.0);
    }

    @Test
    void aHeldKeyStopsThereAndTellsWhy() throws InterruptedException {
        rig.run("1 set guard off");
        try (ManualControl hand = new ManualControl(rig.team().member(1))) {
            hold(
                    hand,
                    FAST,
                    () -> rig.truePose("pioneer").yMm() > START.yMm() + 500
                            && !robot.state().moving());

            assertThat(robot.heldBack()).get().asString().matches(SEEN);
            assertThat(contacts()).isZero();
            assertThat(robot.get("distanceFront").number()).isBetween(60.0, 250.0);
            Pose there = rig.truePose("pioneer");
            hold(hand, -FAST, () -> rig.truePose("pioneer").distanceMm(there) > 300);
        }
        rig.lab().time().sleep(2);
        assertThat(robot.heldBack()).isEmpty();
        assertThat(robot.state().moving()).isFalse();
    }

    @Test
    void withoutAGuardItDrivesIntoTheWall() throws InterruptedException {
        rig.run("1 set guard off", "1 move 5000", "1 drive 400 0 for 20s");

        assertThat(contacts()).isPositive();
    }

    @Test
    void aWallOfTheMapStopsItToo() throws InterruptedException {
        rig.run("map open " + OFFICE);
        robot.place(new Pose(START.xMm(), START.yMm() + 500, START.headingDeg()));

        assertThat(answer("1 move 5000"))
                .matches(".*failed: stopped after [\\d.]+ mm: a wall of the map is \\d+ mm ahead");
        assertThat(rig.truePose("pioneer").yMm()).isLessThan(-5700);
    }

    @Test
    void withoutReadingsItDoesNotMove() throws InterruptedException {
        Pose before = rig.truePose("pioneer");
        rig.run("1 set sonarPower off");

        assertThat(answer("1 move 100")).contains("move 100: failed: ", "no reading of its range sensors for 1 s");
        assertThat(answer("1 turn 90")).contains("turn 90: failed: ", "no reading of its range sensors for 1 s");
        assertThat(answer("1 drive 100 0 for 1s")).contains("failed: ", "no reading of its range sensors for 1 s");
        assertThat(rig.truePose("pioneer")).isEqualTo(before);
    }

    @Test
    void aPlaceThatIsNotKnownLeavesTheMapUnused() throws InterruptedException {
        rig.run("map open " + OFFICE);
        Pose inAWall = new Pose(-8000, 0, 0);
        robot.place(inAWall, Uncertainty.UNKNOWN);

        assertThat(answer("1 move 300")).contains("done");
    }

    @Test
    void aStopEndsAGuardedDrive() throws InterruptedException {
        rig.say("1 drive 200 0 for 30s");
        rig.lab().time().sleep(1);
        assertThat(robot.state().moving()).isTrue();
        rig.run("1 stop");

        rig.lab().time().sleep(1);
        assertThat(robot.state().moving()).isFalse();
    }

    @Test
    void aConditionEndsAGuardedMove() throws InterruptedException {
        assertThat(answer("1 move 2000 until y > -6300")).contains("done (");
    }

    @ParameterizedTest
    @ValueSource(strings = {"aibo", "hemisson", "ros"})
    void otherRobotsStopInFrontOfWhatTheyMeasure(String type) throws InterruptedException {
        try (LabRig all = LabRig.exactWithRos("2")) {
            MajicBot other = all.add(type);
            String last = "";
            for (int move = 0; move < 8 && !last.contains("failed"); move++) {
                List<String> said = all.run("1 set guard on", "1 move 1500");
                last = said.get(said.size() - 1);
            }

            assertThat(last).contains("failed: stopped after", "something that its sensors see is");
            assertThat(all.lab().bumps().values()).allMatch(count -> count == 0);
            assertThat(other.state().moving()).isFalse();
            assertThat(all.run("1 move -20")).last().asString().contains("done");
        }
    }
}
