package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.MajicBot;
import majic.inlab.LabRig;
import org.junit.jupiter.api.Test;

/** A dog of the lab behind a link that carries less than its readings at their full rate. */
class AiboOnASlowLinkTest {
    private static final double BYTES_PER_S = 5000;

    /**
     * A reading may be late by this before the dog sends fewer of them, and as long as a set of slow readings takes.
     */
    private static final double LATEST_MS = 900;

    @Test
    void readingsDoNotQueueUp() throws InterruptedException {
        try (LabRig rig = LabRig.exact()) {
            MajicBot dog = rig.add("aibo");
            rig.lab().simulators().faults("aibo").bandwidth(BYTES_PER_S);

            for (int second = 0; second < 40; second++) {
                rig.lab().time().sleep(1);
                assertThat(dog.get("age").number()).isLessThan(LATEST_MS);
            }
        }
    }

    @Test
    void aConditionStopsTheDogAboutWhereItDoesOnAFastLink() throws InterruptedException {
        double fastMm = stoppedAtMm(Double.POSITIVE_INFINITY);

        assertThat(stoppedAtMm(BYTES_PER_S) - fastMm).isLessThan(LATEST_MS / 1000 * 83);
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
