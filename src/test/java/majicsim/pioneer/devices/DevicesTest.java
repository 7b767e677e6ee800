package majicsim.pioneer.devices;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majicsim.pioneer.model.PioneerModel;
import majicsim.world.Noise;
import org.junit.jupiter.api.Test;

/** Time passes on devices at rest in longer pieces than the steps of the lab; that must not be visible. */
class DevicesTest {
    private static final long STEP_NANOS = 4_000_000;
    private static final byte[] TUNE = {50, 93, 50, 95};

    private final Devices usedInEachStep = devices();
    private final Devices leftAlone = devices();

    private static Devices devices() {
        return new Devices(PioneerModel.of("p3dx-sh+gripper+gyro").equipment(), Noise.seeded(7));
    }

    private void step(int steps, double effort, double degPerSec) {
        for (int step = 0; step < steps; step++) {
            usedInEachStep.step(STEP_NANOS, effort, degPerSec);
            usedInEachStep.battery();
            leftAlone.step(STEP_NANOS, effort, degPerSec);
        }
    }

    @Test
    void theGyroTakesTheSameSamplesWhileTheTurnRateChanges() {
        for (int turn = 0; turn < 20; turn++) {
            step(1 + turn * 7, 0.5, turn * 3);
            assertThat(leftAlone.gyro().toBytes(20))
                    .isEqualTo(usedInEachStep.gyro().toBytes(20));
        }
    }

    @Test
    void theBatteryLosesTheSameCharge() {
        step(40_000, 0.5, 0);
        step(40_000, 1, 0);
        assertThat(leftAlone.battery().charge())
                .isLessThan(1)
                .isCloseTo(usedInEachStep.battery().charge(), within(1e-9));
    }

    @Test
    void aTunePlaysFromTheMomentInWhichItWasOrdered() {
        step(13, 0.5, 0);
        usedInEachStep.buzzer().say(TUNE);
        leftAlone.buzzer().say(TUNE);
        for (int step = 0; step < 600; step++) {
            step(1, 0.5, 0);
            assertThat(leftAlone.isAtRest()).isEqualTo(usedInEachStep.isAtRest());
        }
        assertThat(leftAlone.isAtRest()).isTrue();
        assertThat(leftAlone.buzzer().heard()).isEqualTo(usedInEachStep.buzzer().heard());
    }

    @Test
    void theGripperMovesFromTheMomentInWhichItWasOrdered() {
        step(13, 0.5, 0);
        usedInEachStep.gripper().order(1);
        leftAlone.gripper().order(1);
        assertThat(leftAlone.isAtRest()).isFalse();
        for (int step = 0; step < 2000; step++) {
            step(1, 0.5, 0);
            assertThat(leftAlone.isAtRest()).isEqualTo(usedInEachStep.isAtRest());
        }
        assertThat(leftAlone.gripper().toBytes())
                .isEqualTo(usedInEachStep.gripper().toBytes());
    }
}
