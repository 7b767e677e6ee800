package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.inlab.LabRig;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The driver with simulated robots that count in their own units. */
class ModelScalesInLabTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "powerbot",
                "p2pb",
                "p2at8+",
                "p2it",
                "p2d8+",
                "pion1x",
                "pionat",
                "amigo-sh-tim3xx",
                "researchPB"
            })
    void aModelMovesAndTurnsByItsOwnScale(String model) {
        try (LabRig rig = LabRig.exactWithPioneer(model)) {
            MajicBot bot = rig.add("pioneer");
            Pose before = rig.truePose("pioneer");
            bot.move(200);
            Pose after = rig.truePose("pioneer");
            assertThat(Math.hypot(after.xMm() - before.xMm(), after.yMm() - before.yMm()))
                    .isCloseTo(200, within(12.0));

            bot.turn(90);
            double turned = rig.truePose("pioneer").headingDeg() - after.headingDeg();
            assertThat(Math.floorMod(Math.round(turned), 360)).isBetween(88, 92);
        }
    }

    @Test
    void aModelThatNoTableHasIsNotMoved() {
        try (LabRig rig = LabRig.exactWithPioneer("powerbot+unlisted")) {
            MajicBot bot = rig.add("pioneer");
            Pose before = rig.truePose("pioneer");

            assertThatThrownBy(() -> bot.move(200)).hasMessageContaining("powerbot-unlisted is not known");

            assertThat(rig.truePose("pioneer")).isEqualTo(before);
        }
    }
}
