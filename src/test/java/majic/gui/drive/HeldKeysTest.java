package majic.gui.drive;

import static majic.gui.drive.Direction.AHEAD;
import static majic.gui.drive.Direction.LEFT;
import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class HeldKeysTest {
    private final HeldKeys keys = new HeldKeys();

    @Test
    void aReleaseCountsAfterAMoment() {
        keys.press(AHEAD, 0);
        keys.release(AHEAD, 100);
        assertThat(keys.held(110)).containsExactly(AHEAD);
        assertThat(keys.held(100 + HeldKeys.RELEASE_COUNTS_AFTER_MS)).isEmpty();
    }

    @Test
    void theStreamOfReleasesAndPressesOfX11IsOneHeldKey() {
        keys.press(AHEAD, 0);
        for (long now = 500; now < 5000; now += 30) {
            keys.release(AHEAD, now);
            keys.press(AHEAD, now + 1);
            assertThat(keys.held(now + 29)).containsExactly(AHEAD);
        }
    }

    @Test
    void aKeyWithALostReleaseIsNotHeldForEver() {
        keys.press(AHEAD, 0);
        assertThat(keys.held(HeldKeys.SILENCE_MS - 1)).containsExactly(AHEAD);
        assertThat(keys.held(HeldKeys.SILENCE_MS)).isEmpty();
    }

    @Test
    void lettingGoOneOfTwoKeysLeavesTheOtherHeldForAWhile() {
        keys.press(AHEAD, 0);
        keys.press(LEFT, 10);
        keys.release(LEFT, 500);
        assertThat(keys.held(540)).containsExactly(AHEAD);
        assertThat(keys.held(499 + HeldKeys.SILENCE_AFTER_RELEASE_MS)).containsExactly(AHEAD);
        assertThat(keys.held(500 + HeldKeys.SILENCE_AFTER_RELEASE_MS)).isEmpty();
    }

    @Test
    void releasingAllForgetsEverything() {
        keys.press(AHEAD, 0);
        keys.releaseAll();
        assertThat(keys.held(1)).isEmpty();
    }
}
