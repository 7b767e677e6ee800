package majic.gui.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class ReplayPlayerTest implements ReplayPlayer.Screen {
    private final List<String> shown = new ArrayList<>();
    private int ends;

    @AutoClose
    private final ReplayPlayer player = new ReplayPlayer(10, 20, this);

    @Override
    public void jump(double toS) {
        shown.add("jump " + toS);
    }

    @Override
    public void advance(double fromS, double toS) {
        shown.add("advance " + fromS + " " + toS);
    }

    @Override
    public void moved(double positionS, boolean playing) {
        shown.add((playing ? "playing " : "paused ") + positionS);
    }

    @Override
    public void ended() {
        ends++;
    }

    @Test
    void itStandsAtTheBeginningUntilItPlays() {
        player.tick(1);
        player.tick(1);
        assertThat(shown).containsExactly("jump 10.0", "paused 10.0");
    }

    @Test
    void itAdvancesByTheTimeThatPassedTimesItsSpeed() {
        player.tick(0);
        player.setSpeed(4);
        player.play();
        player.tick(0.5);
        assertThat(shown).endsWith("advance 10.0 12.0", "playing 12.0");
    }

    @Test
    void itPausesAtTheEndAndPlaysFromTheBeginningThen() {
        player.tick(0);
        player.play();
        player.tick(60);
        assertThat(shown).endsWith("advance 10.0 20.0", "paused 20.0");
        player.play();
        player.tick(0);
        assertThat(shown).endsWith("jump 10.0", "playing 10.0");
    }

    @Test
    void aJumpShowsOnlyItsEnd() {
        player.tick(0);
        player.play();
        player.jump(15);
        player.tick(0.5);
        assertThat(shown).endsWith("jump 15.0", "playing 15.0");
    }

    @Test
    void itGoesOnAfterAnErrorOfAPanel() throws InterruptedException {
        CountDownLatch failed = new CountDownLatch(1);
        CountDownLatch shownAgain = new CountDownLatch(1);
        try (ReplayPlayer running = new ReplayPlayer(10, 20, new FailingAtFirst(failed, shownAgain))) {
            running.start();
            failed.await();
            running.jump(15);
            shownAgain.await();
            assertThat(running.position()).isEqualTo(15);
        }
    }

    /** Lacks a class at its first jump. */
    private record FailingAtFirst(CountDownLatch failed, CountDownLatch shownAgain) implements ReplayPlayer.Screen {
        @Override
        public void jump(double toS) {
            if (failed.getCount() > 0) {
                failed.countDown();
                throw new NoClassDefFoundError("a class of the panel");
            }
            shownAgain.countDown();
        }

        @Override
        public void advance(double fromS, double toS) {}

        @Override
        public void moved(double positionS, boolean playing) {}

        @Override
        public void ended() {}
    }

    @Test
    void aJumpEndsWithinTheRecording() {
        player.jump(99);
        assertThat(player.position()).isEqualTo(20);
        player.jump(-5);
        assertThat(player.position()).isEqualTo(10);
    }

    @Test
    void onlyPlayingReachesTheEnd() {
        player.jump(20);
        player.play();
        player.tick(1);
        assertThat(ends).isZero();
        player.jump(19);
        player.tick(1);
        player.play();
        player.tick(2);
        player.tick(1);
        assertThat(ends).isOne();
    }

    @Test
    void aPauseIsShownAtOnce() {
        player.tick(0);
        player.play();
        player.tick(1);
        player.pause();
        player.tick(1);
        assertThat(shown).endsWith("playing 11.0", "paused 11.0");
    }
}
