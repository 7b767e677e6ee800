package majic.lab;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import majic.bot.BotException;
import majic.time.Signal;
import majic.time.TimeSource.Membership;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class LabClockTest {
    private static final long STEP_NANOS = 4_000_000;

    private final AtomicBoolean quiet = new AtomicBoolean(true);
    private volatile Runnable inStep = () -> {};
    private final LabClock clock = new LabClock(STEP_NANOS, () -> inStep.run(), Pacing.stepped(quiet::get));
    private Membership membership = () -> {};

    @BeforeEach
    void joinTheClock() {
        membership = clock.join();
        clock.start();
    }

    @AfterEach
    void leaveTheClock() {
        membership.close();
        clock.close();
    }

    @Test
    void hoursPassWhileAllMembersSleep() throws InterruptedException {
        clock.sleep(7200);

        assertThat(clock.nanos()).isBetween(7_200_000_000_000L, 7_200_004_000_000L);
    }

    @Test
    void doesNotAdvanceWhileAMemberRuns() throws InterruptedException {
        clock.sleep(1);
        long before = clock.nanos();
        long busy = 0;
        for (int round = 0; round < 5_000_000; round++) {
            busy += clock.nanos() - before;
        }

        assertThat(busy).isZero();
    }

    @Test
    void threadsWakeInTheOrderOfTheirTimes() throws InterruptedException {
        List<Double> order = Collections.synchronizedList(new ArrayList<>());
        Signal done = clock.signal();
        for (double seconds : new double[] {0.5, 0.1, 0.3}) {
            clock.thread("sleeper " + seconds, () -> {
                        sleep(seconds);
                        order.add(seconds);
                        done.raise();
                    })
                    .start();
        }
        assertThat(done.await(() -> order.size() == 3, 10)).isTrue();

        assertThat(order).containsExactly(0.1, 0.3, 0.5);
        assertThat(clock.nanos()).isEqualTo(500_000_000);
    }

    @Test
    void aRaisedMemberCountsAsRunningAtOnce() throws InterruptedException {
        AtomicBoolean ready = new AtomicBoolean();
        AtomicLong wokenAt = new AtomicLong(-1);
        Signal signal = clock.signal();
        Signal done = clock.signal();
        clock.thread("waiter", () -> {
                    await(signal, ready);
                    wokenAt.set(clock.nanos());
                    done.raise();
                })
                .start();
        clock.sleep(1);
        ready.set(true);
        signal.raise();
        long raisedAt = clock.nanos();
        done.await(() -> wokenAt.get() >= 0, 10);

        assertThat(wokenAt).hasValue(raisedAt);
    }

    @Test
    void waitsForTheLinesToBecomeQuiet() throws InterruptedException {
        quiet.set(false);
        Thread hush = new Thread(() -> {
            for (int spin = 0; spin < 1000; spin++) {
                Thread.onSpinWait();
            }
            quiet.set(true);
        });
        hush.start();
        clock.sleep(0.004);
        hush.join();

        assertThat(clock.nanos()).isEqualTo(STEP_NANOS);
    }

    @Test
    void theNewTimeIsShownWhileTheLabTakesItsStep() throws InterruptedException {
        List<Long> seen = Collections.synchronizedList(new ArrayList<>());
        inStep = () -> seen.add(clock.nanos());
        clock.sleep(0.008);

        assertThat(seen).containsExactly(STEP_NANOS, 2 * STEP_NANOS);
    }

    @Test
    void whatAStepSentIsHandledBeforeAMemberWhoseTimeHasComeWakes() throws InterruptedException {
        AtomicBoolean handled = new AtomicBoolean();
        inStep = () -> {
            quiet.set(false);
            new Thread(() -> {
                        for (int spin = 0; spin < 1000; spin++) {
                            Thread.onSpinWait();
                        }
                        handled.set(true);
                        quiet.set(true);
                    })
                    .start();
        };
        clock.sleep(0.004);

        assertThat(handled).isTrue();
    }

    @Test
    void membersOfTheSameTimeWakeOneAfterAnotherAsTheyFellAsleep() throws InterruptedException {
        List<Integer> order = Collections.synchronizedList(new ArrayList<>());
        Signal done = clock.signal();
        for (int number = 1; number <= 8; number++) {
            int own = number;
            clock.sleep(0.004);
            double untilOneSecond = 1 - clock.nanos() / 1e9;
            clock.thread("sleeper " + own, () -> {
                        sleep(untilOneSecond);
                        order.add(own);
                        done.raise();
                    })
                    .start();
        }
        assertThat(done.await(() -> order.size() == 8, 10)).isTrue();

        assertThat(order).containsExactly(1, 2, 3, 4, 5, 6, 7, 8);
    }

    @Test
    void aRaisedMemberWakesEvenIfAnotherOneNeverWaits() {
        AtomicBoolean ready = new AtomicBoolean();
        AtomicBoolean woken = new AtomicBoolean();
        Signal signal = clock.signal();
        clock.thread("waiter", () -> {
                    await(signal, ready);
                    woken.set(true);
                })
                .start();
        ready.set(true);
        signal.raise();
        while (!woken.get()) {
            Thread.onSpinWait();
        }

        assertThat(clock.nanos()).isZero();
    }

    @Test
    void aThreadThatCannotStartHoldsNothingUp() throws InterruptedException {
        clock.thread("never started", () -> {});
        Thread started = clock.thread("started once", () -> {});
        started.start();
        started.join();
        assertThatThrownBy(started::start).isInstanceOf(IllegalThreadStateException.class);

        clock.sleep(1);

        assertThat(clock.nanos()).isEqualTo(1_000_000_000);
    }

    @Test
    void anErrorInTheLabEndsEveryWaitWithAMessage() throws InterruptedException {
        AtomicReference<String> why = new AtomicReference<>();
        Signal never = clock.signal();
        Thread other = clock.thread("other", () -> {
            try {
                await(never, new AtomicBoolean());
            } catch (BotException e) {
                why.set(e.getMessage());
            }
        });
        other.start();
        inStep = () -> {
            throw new IllegalStateException("a mistake");
        };

        assertThatThrownBy(() -> clock.sleep(1))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("the simulated lab has ended")
                .hasMessageContaining("a mistake");

        other.join();
        assertThat(why.get()).contains("the simulated lab has ended");
        assertThatThrownBy(() -> clock.sleep(1)).isInstanceOf(BotException.class);
    }

    @Test
    void aClockThatDoesNotAdvanceReportsWhatDelaysIt() {
        CountDownLatch testIsOver = new CountDownLatch(1);
        LabClock stalling = new LabClock(STEP_NANOS, () -> {}, Pacing.stepped(quiet::get), 1);
        stalling.start();
        stalling.thread("stuck", () -> {
                    try {
                        testIsOver.await();
                    } catch (InterruptedException e) {
                        Thread.currentThread().interrupt();
                    }
                })
                .start();

        assertThatThrownBy(() -> stalling.sleep(1))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("has stood still for 1 s")
                .hasMessageMatching("(?s).*stuck: running for [1-9]\\d?\\.\\d s.*")
                .hasMessageContaining("CountDownLatch.await");
        testIsOver.countDown();
    }

    @Test
    void timedWaitsEndAtTheSystemsPaceOnceTheClockIsClosed() throws InterruptedException {
        LabClock closing = new LabClock(4_000_000, () -> {}, new NeverStepping());
        closing.start();
        Thread before = closing.thread("waits before", () -> sleepOn(closing));
        before.start();
        closing.close();
        Thread after = closing.thread("waits after", () -> sleepOn(closing));
        after.start();

        before.join();
        after.join();
        assertThat(closing.nanos()).isGreaterThanOrEqualTo(10_000_000);
    }

    /** A pacing that allows no step. */
    private static final class NeverStepping implements Pacing {
        @Override
        public boolean mayStep(long nowNanos, BooleanSupplier membersWait) {
            Thread.yield();
            return false;
        }

        @Override
        public boolean awaitsMembers() {
            return false;
        }
    }

    private static void sleepOn(LabClock clock) {
        try {
            clock.sleep(0.01);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static void await(Signal signal, AtomicBoolean ready) {
        try {
            signal.await(ready::get, Signal.FOR_EVER);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void sleep(double seconds) {
        try {
            clock.sleep(seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
