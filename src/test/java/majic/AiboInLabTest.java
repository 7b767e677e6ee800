package majic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.bot.MajicBot;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The Aibo's driver against the simulated dog. */
@Timeout(60)
class AiboInLabTest {
    @Test
    void theHeadLooksWhereItWasToldRightAfterAWalk() throws InterruptedException {
        try (LabRig rig = LabRig.noisy(1)) {
            MajicBot dog = rig.add("aibo");
            dog.move(200);

            dog.set("headPan", 40);
            rig.lab().time().sleep(1);

            assertThat(dog.get("headPan").number()).isCloseTo(40, within(1.0));
        }
    }

    @Test
    void thePostureIsTakenAndTold() {
        try (LabRig rig = LabRig.exact()) {
            MajicBot dog = rig.add("aibo");

            dog.set("posture", "sit");

            assertThat(dog.get("posture")).hasToString("sit");
            assertThat(dog.get("motors").isYes()).isTrue();
        }
    }
}
