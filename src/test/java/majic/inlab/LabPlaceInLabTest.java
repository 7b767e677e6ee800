package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.Pose;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Robots of the lab that are put down elsewhere by a line of MAJIC Script. */
class LabPlaceInLabTest {
    @AutoClose
    private final LabRig rig = LabRig.exact().withAllRobots();

    @Test
    void aPlacedRobotIsThereReportsThatAndDrivesFromThere() throws InterruptedException {
        assertThat(rig.run("lab place 2 -1000 200 90")).containsExactly("2 lab place -1000 200 90: done");
        assertThat(rig.truePose("pioneer")).isEqualTo(new Pose(-1000, 200, 90));

        rig.run("2 move 300");
        assertThat(rig.truePose("pioneer").distanceMm(new Pose(-1000, 500, 90))).isLessThan(20);
        assertThat(rig.team().member(2).bot().state().pose().distanceMm(rig.truePose("pioneer")))
                .isLessThan(20);
    }

    @Test
    void aRobotThatIsCarriedAwayDoesNotKnow() throws InterruptedException {
        Pose reported = rig.team().member(2).bot().state().pose();

        assertThat(rig.run("lab carry 2 -1000 200 90")).containsExactly("2 lab carry -1000 200 90: done");
        assertThat(rig.truePose("pioneer")).isEqualTo(new Pose(-1000, 200, 90));
        assertThat(rig.team().member(2).bot().state().pose()).isEqualTo(reported);
    }

    @Test
    void wallsOtherRobotsAndWhatIsOutsideTheRoomRefuseARobot() throws InterruptedException {
        Pose before = rig.truePose("pioneer");
        assertThat(rig.run("lab place 2 4500 0 0", "2 wait"))
                .contains("2 lab place 4500 0 0: failed: a wall or another robot is there");
        assertThat(rig.run("lab place 2 -2000 1900 0", "2 wait"))
                .contains("2 lab place -2000 1900 0: failed: a wall or another robot is there");
        assertThat(rig.run("lab place 2 9m 0 0", "2 wait"))
                .contains("2 lab place 9m 0 0: failed: that is outside the room");
        assertThat(rig.truePose("pioneer")).isEqualTo(before);
        assertThat(rig.team().member(2).bot().placedAt()).isEmpty();
    }

    @Test
    void theListCountsTheBumpsOfEachRobot() throws InterruptedException {
        assertThat(rig.run("lab")).allMatch(line -> line.endsWith("bumps=0"));
        rig.lab().simulators().place("hemisson", new majicsim.world.Pose(-2000, -3400, -90));
        rig.run("3 move 100", "3 wait");
        assertThat(rig.run("lab")).anyMatch(line -> line.startsWith("lab: hemisson") && !line.endsWith("bumps=0"));
    }
}
