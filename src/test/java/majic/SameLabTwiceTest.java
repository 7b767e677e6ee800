package majic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Set;
import majic.bot.Pose;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that a stepped lab does not depend on which of its threads the computer runs first. */
@Timeout(120)
class SameLabTwiceTest {
    private static final int SECONDS = 45;

    @ParameterizedTest
    @ValueSource(longs = {1, 3})
    void robotsOfTheSameLabMoveTheSameWay(long seed) throws InterruptedException {
        Map<String, List<Pose>> ways = wander(seed);

        assertThat(ways.values()).hasSize(3).allMatch(way -> Set.copyOf(way).size() > SECONDS / 3);
        assertThat(wander(seed)).isEqualTo(ways);
    }

    private static Map<String, List<Pose>> wander(long seed) throws InterruptedException {
        try (LabRig rig = LabRig.noisy(seed).withAllRobots()) {
            rig.say("1 act WanderDog");
            rig.say("2 act PioneerWander");
            rig.say("3 act LineFollow");
            return ActLabs.watch(rig, SECONDS);
        }
    }
}
