package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.MajicBot;
import majic.inlab.LabRig;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A dog of the lab behind a link that carries less than its readings at their full rate. */
class AiboOnASlowLinkTest {
    /** In this time the queue of the beginning is gone; a motion would be stopped by readings that are too old, s. */
    private static final int FIRST_S = 10;

    /** How old a reading may be from then on, ms. */
    private static final double USUAL_MS = 900;

    private static final double CRUISE_MM_PER_MS = 0.083;

    @ParameterizedTest
    @ValueSource(doubles = {5000, 3000})
    void readingsDoNotQueueUp(double bytesPerSecond) throws InterruptedException {
        try (LabRig rig = LabRig.exact()) {
            MajicBot dog = rig.add("aibo");
            rig.lab().simulators().faults("aibo").bandwidth(bytesPerSecond);

            rig.lab().time().sleep(FIRST_S);

            for (int second = 0; second < 60; second++) {
                assertThat(dog.get("age").number()).isLessThan(USUAL_MS);
                rig.lab().time().sleep(1);
            }
        }
    }

    @Test
    void aConditionStopsTheDogAboutWhereItDoesOnAFastLink() throws InterruptedException {
        double fastMm = stoppedAtMm(Double.POSITIVE_INFINITY);

        assertThat(stoppedAtMm(3000) - fastMm).isLessThan(USUAL_MS * CRUISE_MM_PER_MS);
    }

    private static double stoppedAtMm(double bytesPerSecond) throws InterruptedException {
        try (LabRig rig = LabRig.exact()) {
            rig.add("aibo");
            rig.lab().simulators().faults("aibo").bandwidth(bytesPerSecond);
            rig.lab().time().sleep(30);

            assertThat(rig.run("1 move 3000 until distanceFront < 400")).anyMatch(line -> line.contains(": done ("));
            return rig.truePose("aibo").xMm();
        }
    }
}
