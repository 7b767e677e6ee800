package majic.inlab.acts;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import majic.bot.Pose;
import majic.inlab.LabRig;
import majicsim.LabOptions;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** The acts that go to places, with two Pioneers that have lasers, on the map of the lab. */
class PlaceActsInLabTest {
    private static final Path MAP = Path.of("sims", "worlds", "lab.map");

    @AutoClose
    private final LabRig rig =
            LabRig.of(LabOptions.exactOnFreePorts().withPioneer("p3dx-sh+laser").withPioneers(2));

    private void openMap() throws InterruptedException {
        ActLabs.place(rig, "pioneer2", new Pose(2500, 500, 180));
        List.of("pioneer", "pioneer2").forEach(name -> rig.add(name).place(rig.truePose(name)));
        rig.run("map open " + MAP, "map place a 0 1500", "map place b 1500 0 90");
    }

    private double apart() {
        return rig.truePose("pioneer").distanceMm(rig.truePose("pioneer2"));
    }

    @Test
    void aPatrolVisitsItsPlacesInTurn() throws InterruptedException {
        openMap();

        assertThat(rig.run("1 act Patrol places=\"a b\" times=2 pause=1s"))
                .containsSubsequence(
                        "1: Patrol: round 1, to a",
                        "1: Patrol: round 1, to b",
                        "1: Patrol: round 2, to a",
                        "1: Patrol: round 2, to b")
                .last()
                .asString()
                .contains(": done (");
        assertThat(rig.truePose("pioneer").distanceMm(new Pose(1500, 0, 90))).isLessThan(50);
        assertThat(ActLabs.bumps(rig)).containsEntry("pioneer", 0);
    }

    @Test
    void aPatrolWithoutPlacesFailsWithWhatWouldBeRight() throws InterruptedException {
        openMap();

        assertThat(rig.run("1 act Patrol")).last().asString().contains("which places? As in places=\"desk door\"");
    }

    @Test
    void goToGoesToAPlaceOrToCoordinates() throws InterruptedException {
        openMap();

        assertThat(rig.run("1 act GoTo place=a")).last().asString().contains("done");
        assertThat(rig.truePose("pioneer").distanceMm(new Pose(0, 1500, 0))).isLessThan(50);
        assertThat(rig.run("1 act GoTo x=1m y=-500")).last().asString().contains("done");
        assertThat(rig.truePose("pioneer").distanceMm(new Pose(1000, -500, 0))).isLessThan(50);
        assertThat(rig.run("1 act GoTo place=desk")).last().asString().contains("there is no such place on the map");
    }

    @Test
    void exploreBuildsTheMap() throws InterruptedException {
        rig.add("pioneer");

        assertThat(rig.run("1 act Explore"))
                .anyMatch(line -> line.matches("1: Explore: explored \\d+ frontiers, [56]\\d m², .*"))
                .last()
                .asString()
                .contains("1 act Explore: done (");
        assertThat(ActLabs.bumps(rig)).containsEntry("pioneer", 0);
    }

    @Test
    void aFollowerKeepsItsDistanceFromARobotThatOthersDrive() throws InterruptedException {
        openMap();
        rig.say("1 act Follow leader=2 distance=1200");
        rig.lab().time().sleep(10);
        assertThat(apart()).isBetween(1100.0, 1300.0);

        assertThat(rig.run("2 goto -2500 500"))
                .anyMatch(line -> line.startsWith("2 goto -2500 500: done ("))
                .last()
                .asString()
                .startsWith("1 act Follow leader=2 distance=1200: done (");
        assertThat(apart()).isBetween(900.0, 1400.0);
        assertThat(ActLabs.bumps(rig)).containsEntry("pioneer", 0).containsEntry("pioneer2", 0);
    }

    @Test
    void aStopEndsAPatrol() throws InterruptedException {
        openMap();
        rig.say("1 act Patrol places=\"a b\" times=100");
        rig.lab().time().sleep(12);
        rig.run("1 stop");
        Pose stood = rig.truePose("pioneer");
        rig.lab().time().sleep(10);

        assertThat(rig.truePose("pioneer")).isEqualTo(stood);
    }
}
