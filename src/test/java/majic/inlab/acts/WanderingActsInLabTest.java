package majic.inlab.acts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Stream;
import majic.bot.Pose;
import majic.inlab.LabRig;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Tests that the shipped wander behaviours move around for ten minutes among walls, boxes and stationary robots without
 * a collision.
 */
@Tag("long")
class WanderingActsInLabTest {
    private static final int TEN_MINUTES_S = 600;
    private static final int TO_THE_WALL_S = 20;
    private static final int ONE_ROUND_S = 330;

    static Stream<Named<Supplier<LabRig>>> labs() {
        return ActLabs.labs();
    }

    @ParameterizedTest(name = "in {0}")
    @MethodSource("labs")
    void theDogWandersIntoNothing(Supplier<LabRig> lab) throws InterruptedException {
        wander(lab, "aibo", "WanderDog", 8);
    }

    @ParameterizedTest(name = "in {0}")
    @MethodSource("labs")
    void thePioneerWandersIntoNothing(Supplier<LabRig> lab) throws InterruptedException {
        wander(lab, "pioneer", "PioneerWander", 14);
    }

    private static void wander(Supplier<LabRig> lab, String robot, String act, long squareMetres)
            throws InterruptedException {
        try (LabRig rig = ActLabs.with(lab, robot)) {
            rig.say("1 act " + act);
            Map<String, List<Pose>> ways = ActLabs.watch(rig, TEN_MINUTES_S);

            assertThat(rig.said()).noneMatch(line -> line.contains("failed"));
            assertThat(ActLabs.bumps(rig)).containsEntry(robot, 0);
            assertThat(ActLabs.metresVisited(ways.get(robot))).isGreaterThanOrEqualTo(squareMetres);
        }
    }

    @ParameterizedTest(name = "in {0}")
    @MethodSource("labs")
    void theWallFollowerGoesRoundTheRoom(Supplier<LabRig> lab) throws InterruptedException {
        try (LabRig rig = lab.get()) {
            ActLabs.place(rig, "aibo", new Pose(0, 700, 0));
            ActLabs.place(rig, "hemisson", new Pose(0, -700, 0));
            rig.add("pioneer");
            rig.say("1 act WallFollow");
            rig.lab().time().sleep(TO_THE_WALL_S);
            Rounds rounds = new Rounds(new Pose(0, 0, 0));
            List<Pose> way = ActLabs.watch(rig, ONE_ROUND_S).get("pioneer");
            way.forEach(rounds::add);

            assertThat(rounds.done()).isGreaterThan(1);
            assertThat(way).allMatch(pose -> ActLabs.toTheWalls(rig, pose) < 1300);
            assertThat(way.stream().filter(pose -> ActLabs.toTheWalls(rig, pose) < 1000))
                    .hasSizeGreaterThan(ONE_ROUND_S * 9 / 10);
            assertThat(ActLabs.bumps(rig)).containsEntry("pioneer", 0);
        }
    }
}
