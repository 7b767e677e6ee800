package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.atomic.AtomicBoolean;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import majic.time.TimeSource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What ends a wait of a driver. */
class RobotWaitTest {
    private static final double LONG_S = 60;

    private final TimeSource time = TimeSource.system();
    private final RobotWait waiting = new RobotWait(time, time.signal());

    @AfterEach
    void clearInterruption() {
        Thread.interrupted();
    }

    @Test
    void aChangeThatMakesTheConditionTrueEndsTheWait() {
        AtomicBoolean done = new AtomicBoolean();
        time.thread("change", () -> {
                    done.set(true);
                    waiting.changes().raise();
                })
                .start();

        assertThat(waiting.await(done::get, LONG_S)).isTrue();
    }

    @Test
    void aWaitEndsWhenItsTimeIsOver() {
        assertThat(waiting.await(() -> false, 0)).isFalse();
        assertThat(waiting.awaitConnecting(() -> false, 0)).isFalse();
        assertThat(waiting.awaitClosing(() -> false, 0)).isFalse();
    }

    @Test
    void anInterruptionOfAConnectedRobotIsAStop() {
        Thread.currentThread().interrupt();

        assertThatThrownBy(() -> waiting.await(() -> false, LONG_S)).isInstanceOf(MotionStopped.class);
        assertThat(Thread.currentThread().isInterrupted()).isTrue();
    }

    @Test
    void anInterruptionWhileConnectingEndsTheAttempt() {
        Thread.currentThread().interrupt();

        assertThatThrownBy(() -> waiting.awaitConnecting(() -> false, LONG_S))
                .isExactlyInstanceOf(BotException.class)
                .hasMessage("interrupted while connecting");
    }

    @Test
    void anInterruptionWhileClosingEndsOnlyTheWait() {
        Thread.currentThread().interrupt();

        assertThat(waiting.awaitClosing(() -> false, LONG_S)).isFalse();
        assertThat(Thread.currentThread().isInterrupted()).isTrue();
    }
}
