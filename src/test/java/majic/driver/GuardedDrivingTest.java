package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import majic.bot.DriveGuard;
import majic.bot.FakeBot;
import majic.bot.MotionFailed;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class GuardedDrivingTest {
    private static final DriveGuard.Room NEAR = new DriveGuard.Room(25, "a chair is 125 mm ahead");

    @AutoClose
    private final SteppedBot stepped = new SteppedBot();

    private final FakeBot bot = stepped.bot;
    private final Fake guard = new Fake();

    GuardedDrivingTest() {
        bot.useGuard(guard);
    }

    /** Answers with the same room until another one is set. */
    private static final class Fake implements DriveGuard {
        final AtomicReference<Room> room = new AtomicReference<>(Room.FREE);
        final AtomicInteger asked = new AtomicInteger();
        volatile Runnable before = () -> {};
        volatile boolean possible = true;

        @Override
        public boolean isPossible() {
            return possible;
        }

        @Override
        public Room room(double mmPerSec, double degPerSec) {
            asked.incrementAndGet();
            before.run();
            return room.get();
        }
    }

    @Test
    void itIsOffAtFirstAndAsksNothing() {
        guard.room.set(NEAR);

        assertThat(bot.get("guard")).hasToString("off");
        assertThat(bot.move(300)).hasToString("300 mm, 1.0 s");
        bot.drive(100, 0);
        assertThat(bot.sent()).contains("drive 100 0");
        assertThat(guard.asked).hasValue(0);
    }

    @Test
    void aMoveEndsAndFailsWhenThereIsLessRoomThanItNeedsToBrake() {
        bot.set("guard", "on");
        guard.room.set(new DriveGuard.Room(200, "a chair is 300 mm ahead"));

        assertThatThrownBy(() -> bot.move(1000))
                .isInstanceOf(MotionFailed.class)
                .hasMessageMatching("stopped after [1-9]\\d* mm: a chair is 300 mm ahead");
        assertThat(bot.sent()).endsWith("halt");
    }

    @Test
    void aMoveThatEndsBeforeTheObstacleIsDone() {
        bot.set("guard", "on");
        guard.room.set(new DriveGuard.Room(400, "a chair is 500 mm ahead"));

        assertThat(bot.move(300)).hasToString("300 mm, 1.0 s");
    }

    @Test
    void aDriveIsSlowerInFrontOfAnObstacleAndStopsBeforeIt() {
        bot.set("guard", "on");
        guard.room.set(NEAR);

        bot.drive(300, 30);

        assertThat(bot.sent()).last().asString().matches("drive 6\\d(\\.\\d+)? 6(\\.\\d+)?");
        assertThat(bot.heldBack()).contains("a chair is 125 mm ahead");

        guard.room.set(new DriveGuard.Room(0, "a chair is 100 mm ahead"));
        bot.drive(300, 30);

        assertThat(bot.sent()).last().isEqualTo("halt");
        assertThat(bot.heldBack()).contains("a chair is 100 mm ahead");
    }

    @Test
    void aTurnOnTheSpotFailsWithoutReadings() {
        bot.set("guard", "on");
        assertThat(bot.turn(90)).hasToString("90 deg, 1.0 s");

        guard.room.set(new DriveGuard.Room(0, "no reading of its range sensors for 1 s"));

        assertThatThrownBy(() -> bot.turn(90))
                .isInstanceOf(MotionFailed.class)
                .hasMessageEndingWith(": no reading of its range sensors for 1 s");
    }

    @Test
    void aRobotThatHasNothingToGoByMovesAsBefore() {
        bot.set("guard", "on");
        guard.possible = false;
        guard.room.set(NEAR);

        assertThat(bot.move(300)).hasToString("300 mm, 1.0 s");
        bot.drive(300, 0);
        assertThat(bot.sent()).last().isEqualTo("drive 300 0");
    }

    @Test
    void aGuardThatFailsHoldsTheRobot() {
        bot.set("guard", "on");
        guard.before = () -> {
            throw new IllegalStateException("a mistake");
        };

        assertThatThrownBy(() -> bot.move(300))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("its guard failed");
        bot.drive(300, 0);
        assertThat(bot.sent()).noneMatch(sent -> sent.startsWith("drive"));
    }

    @Test
    void aStopIsSentWhileTheGuardHangs() throws InterruptedException {
        bot.drive(100, 0);
        bot.set("guard", "on");
        CountDownLatch hangs = new CountDownLatch(1);
        CountDownLatch end = new CountDownLatch(1);
        guard.before = () -> {
            hangs.countDown();
            awaitEnd(end);
        };
        Thread driving = new Thread(() -> assertThatThrownBy(() -> bot.drive(100, 0)));
        driving.start();
        hangs.await();

        bot.stop();

        assertThat(bot.sent()).last().isEqualTo("halt");
        end.countDown();
        driving.join();
        assertThat(bot.sent()).last().isEqualTo("halt");
    }

    private static void awaitEnd(CountDownLatch end) {
        try {
            end.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
