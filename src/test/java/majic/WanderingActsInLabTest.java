package majic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Stream;
import majic.bot.Pose;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The shipped wanderers drive into nothing in ten minutes among walls, boxes and robots that stand, and get around. */
@Timeout(120)
class WanderingActsInLabTest {
    private static final int TEN_MINUTES_S = 600;

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
}
