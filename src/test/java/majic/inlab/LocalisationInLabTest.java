package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.MajicBot;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** A Pioneer with a laser that maps the room of the lab and is then carried away without knowing. */
class LocalisationInLabTest {
    @AutoClose
    private final LabRig rig = LabRig.exactWithPioneer("p3dx-sh+laser").withAllRobots();

    private void tour() throws InterruptedException {
        rig.run("2 move 1500", "2 turn 90", "2 move 1200", "2 turn 90", "2 move 2500", "2 turn 180", "2 wait");
    }

    @Test
    void aRobotThatWasCarriedAwayFindsItselfOnTheMapThatItHasBuilt() throws InterruptedException {
        MajicBot robot = rig.team().member(2).bot();
        rig.run("map start 2");
        tour();
        rig.run("map stop");
        assertThat(robot.uncertainty().sigmaMm()).isLessThan(100);

        rig.run("lab carry 2 1500 -1500 90");
        rig.run("2 move 1500", "2 turn 90", "2 move 1500", "2 turn 180", "2 move 1200", "2 turn 90", "2 wait");

        assertThat(robot.uncertainty().isKnown()).isTrue();
        assertThat(robot.state().pose().distanceMm(rig.truePose("pioneer"))).isLessThan(100);
    }
}
