package majic.inlab.acts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import majic.bot.Pose;
import majic.inlab.LabRig;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Tests that the arguments of the shipped behaviours change what the robots do. */
@Tag("long")
class ActArgumentsInLabTest {
    @Test
    void aWandererIsAsSlowAsItsSpeed() throws InterruptedException {
        assertThat(wandered("")).isBetween(600.0, 1500.0);
        assertThat(wandered(" speed=100")).isBetween(250.0, 500.0);
    }

    /** Returns how far a Pioneer has wandered after five seconds, mm. */
    private static double wandered(String arguments) throws InterruptedException {
        try (LabRig rig = ActLabs.with(LabRig::exact, "pioneer")) {
            Pose start = rig.truePose("pioneer");
            rig.say("1 act PioneerWander" + arguments);
            rig.lab().time().sleep(5);
            return rig.truePose("pioneer").distanceMm(start);
        }
    }

    @Test
    void aWandererTurnsAtItsNearDistance() throws InterruptedException {
        assertThat(nearestToTheWalls(" near=1500 speed=200")).isGreaterThan(1300);
        assertThat(nearestToTheWalls(" near=500 speed=200")).isLessThan(1000);
    }

    private static double nearestToTheWalls(String arguments) throws InterruptedException {
        try (LabRig rig = LabRig.exact()) {
            ActLabs.place(rig, "aibo", new Pose(-2000, 1500, 0));
            ActLabs.place(rig, "hemisson", new Pose(-2000, -1500, 0));
            rig.add("pioneer");
            rig.say("1 act PioneerWander" + arguments);
            List<Pose> way = ActLabs.watch(rig, 25).get("pioneer");
            return way.stream()
                    .mapToDouble(pose -> ActLabs.toTheWalls(rig, pose))
                    .min()
                    .orElseThrow();
        }
    }

    @Test
    void anyRobotGoesAlongASquareWithTheGivenSide() throws InterruptedException {
        try (LabRig rig = ActLabs.with(LabRig::exact, "pioneer")) {
            Pose start = rig.truePose("pioneer");
            assertThat(rig.run("1 act AiboSquare side=0.2m")).last().asString().contains("side=0.2m: done");
            assertThat(rig.truePose("pioneer").distanceMm(start)).isLessThan(60);
            rig.say("1 act AiboSquare side=0.2m");
            List<Pose> way = ActLabs.watch(rig, 30).get("pioneer");
            assertThat(way).allMatch(pose -> pose.distanceMm(start) < 350);
        }
    }

    @Test
    void aFollowerKeepsTheGivenDistance() throws InterruptedException {
        try (LabRig rig = LabRig.exact()) {
            ActLabs.place(rig, "aibo", new Pose(-1000, 0, 0));
            ActLabs.place(rig, "pioneer", new Pose(-2100, 0, 0));
            rig.add("aibo");
            rig.add("pioneer");
            rig.say("1 act Convoy distance=650 with 2");
            rig.lab().time().sleep(15);
            Map<String, List<Pose>> ways = ActLabs.watch(rig, 15);
            for (int second = 0; second < 15; second++) {
                assertThat(ways.get("aibo")
                                .get(second)
                                .distanceMm(ways.get("pioneer").get(second)))
                        .isBetween(1000.0, 1250.0);
            }
        }
    }

    @Test
    void aRaceIsAsLongAsItsCourse() throws InterruptedException {
        try (LabRig rig = LabRig.exact()) {
            ActLabs.place(rig, "pioneer", new Pose(-1000, 0, 0));
            ActLabs.place(rig, "hemisson", new Pose(-1000, -700, 0));
            rig.add("pioneer");
            rig.add("hemisson");
            rig.run("1 act MajicRace course=30cm with 2");
            assertThat(rig.truePose("pioneer").xMm()).isBetween(-700.0, -550.0);
            assertThat(rig.truePose("hemisson").xMm()).isBetween(-700.0, -600.0);
        }
    }
}
