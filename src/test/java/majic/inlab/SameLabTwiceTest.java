package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import majic.bot.Pose;
import majic.inlab.acts.ActLabs;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that a stepped lab runs the same way however busy the computer is. */
class SameLabTwiceTest {
    private static final int SECONDS = 60;

    @ParameterizedTest
    @ValueSource(strings = {"PioneerWander", "WallFollow"})
    void aRobotOfTheSameLabMovesTheSameWay(String act) throws InterruptedException {
        List<Pose> way = way(act);

        assertThat(Set.copyOf(way)).hasSizeGreaterThan(SECONDS / 2);
        assertThat(way(act)).isEqualTo(way);
    }

    private static List<Pose> way(String act) throws InterruptedException {
        try (LabRig rig = ActLabs.with(() -> LabRig.noisy(1), "pioneer")) {
            rig.say("1 act " + act);
            return ActLabs.watch(rig, SECONDS).get("pioneer");
        }
    }
}
