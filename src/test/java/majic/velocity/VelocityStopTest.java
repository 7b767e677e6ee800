package majic.velocity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import majic.bot.BotException;
import majic.bot.Guard;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import majic.bot.Pose;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** A stop of a base: at once, repeated, confirmed by the odometry. */
class VelocityStopTest {
    @AutoClose
    private final ModelRobot robot =
            new ModelRobot(BaseModel.Traits.USUAL.drivingOn().heavy(300)).connected();

    private final ModelDriver bot = robot.bot();

    private CompletableFuture<MotionReport> moving() {
        CompletableFuture<MotionReport> motion = robot.clock.aside(() -> bot.move(2000));
        robot.clock.until(() -> robot.base.mmPerSec() > 140);
        return motion;
    }

    private List<BaseModel.Command> since(long ms) {
        return robot.base.received().stream().filter(sent -> sent.atMs() >= ms).toList();
    }

    @Test
    void theZeroVelocityIsPublishedAtOnceAndRepeatedUntilTheBaseIsStationary() {
        CompletableFuture<MotionReport> motion = moving();
        long stoppedMs = robot.base.nowMs();

        bot.stop();

        assertThatThrownBy(() -> robot.clock.join(motion)).hasCauseInstanceOf(MotionStopped.class);
        List<BaseModel.Command> stops = since(stoppedMs);
        assertThat(stops.get(0).atMs()).isLessThanOrEqualTo(stoppedMs + 1);
        assertThat(stops).allMatch(BaseModel.Command::isZero).hasSizeGreaterThanOrEqualTo(4);
        for (int i = 1; i < stops.size(); i++) {
            assertThat(stops.get(i).atMs() - stops.get(i - 1).atMs()).isLessThanOrEqualTo(101);
        }
    }

    @Test
    void theStopIsConfirmedOnlyWhenTheBaseIsStationary() {
        moving();

        bot.stop();

        assertThat(robot.base.mmPerSec()).isZero();
        assertThat(bot.state().moving()).isFalse();
        Pose place = robot.truePose();
        pass(2);
        assertThat(robot.truePose()).isEqualTo(place);
    }

    @Test
    void nothingIsPublishedAfterAConfirmedStop() {
        moving();
        bot.stop();
        pass(0.3);
        long quietMs = robot.base.nowMs();

        pass(3);

        assertThat(since(quietMs)).isEmpty();
    }

    @Test
    void aLatchedStopAllowsNothingButZeros() {
        CompletableFuture<MotionReport> motion = moving();
        long stoppedMs = robot.base.nowMs();
        bot.latch();
        bot.sendStop();

        assertThatThrownBy(() -> bot.drive(100, 0)).isInstanceOf(BotException.class);
        assertThatThrownBy(() -> bot.move(100)).isInstanceOf(BotException.class);
        pass(2);

        assertThat(motion).isCompletedExceptionally();
        assertThat(since(stoppedMs)).isNotEmpty().allMatch(BaseModel.Command::isZero);
    }

    @Test
    void aBaseThatIgnoresTheStopIsNamedAndTheStopIsRepeated() {
        moving();
        robot.base.deaf = true;
        long stoppedMs = robot.base.nowMs();

        assertThatThrownBy(bot::stop)
                .isInstanceOf(BotException.class)
                .hasMessageContaining("has not come to rest within 4 s of the stop")
                .hasMessageContaining("its odometry shows 150 mm/s and 0 deg/s");
        assertThat(since(stoppedMs)).allMatch(BaseModel.Command::isZero).hasSizeGreaterThan(70);
    }

    @Test
    void aStopWithoutOdometryIsNotConfirmed() {
        moving();
        robot.base.silent = true;

        assertThatThrownBy(bot::stop)
                .isInstanceOf(BotException.class)
                .hasMessageContaining("its odometry has been silent for 1 s");
    }

    @Test
    void aStopOfAStationaryBaseIsConfirmedAtOnce() {
        pass(0.5);
        double before = bot.time().nanos() / 1e9;

        bot.stop();

        assertThat(bot.time().nanos() / 1e9 - before).isLessThan(0.3);
    }

    @Test
    void aMotionOfABaseThatDoesNotComeToRestFails() {
        CompletableFuture<MotionReport> motion = robot.clock.aside(() -> bot.move(400));
        robot.clock.until(() -> robot.truePose().xMm() > 200);
        robot.base.deaf = true;

        assertThatThrownBy(() -> robot.clock.join(motion)).hasMessageContaining("it does not come to rest after");
    }

    @Test
    void aVelocityIsSetToZeroIfTheGuardConditionDoesNotReturn() {
        Guard stuck = () -> {
            if (robot.truePose().xMm() > 100) {
                pass(5);
            }
            return false;
        };
        CompletableFuture<MotionReport> motion = robot.clock.aside(() -> bot.move(1000, stuck));
        robot.clock.until(() -> robot.truePose().xMm() > 100);

        pass(2);

        assertThat(robot.base.mmPerSec()).isZero();
        bot.stop();
        assertThatThrownBy(() -> robot.clock.join(motion))
                .isInstanceOf(CompletionException.class)
                .hasCauseInstanceOf(MotionStopped.class);
    }

    @Test
    void aMotionAfterAStopBeginsWhenTheBaseIsStationary() {
        bot.drive(200, 0);
        robot.clock.until(() -> robot.base.mmPerSec() > 100);

        MotionReport report = bot.move(100);

        assertThat(report.amount().number()).isBetween(99.0, 101.0);
    }

    @Test
    void aClosedRobotHasReceivedTheStopSeveralTimes() {
        moving();
        long closedMs = robot.base.nowMs();

        bot.close();

        assertThat(since(closedMs)).hasSizeGreaterThanOrEqualTo(3).allMatch(BaseModel.Command::isZero);
        assertThat(robot.base.nowMs() - closedMs).isLessThan(200);
    }

    private void pass(double seconds) {
        try {
            bot.time().sleep(seconds);
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }
}
