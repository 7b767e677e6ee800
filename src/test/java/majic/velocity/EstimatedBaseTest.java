package majic.velocity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.concurrent.CompletableFuture;
import majic.bot.MotionReport;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A base without odometry: its position is calculated from the velocities sent. */
class EstimatedBaseTest {
    @AutoClose
    private final ModelRobot robot =
            new ModelRobot(BaseModel.Traits.USUAL, VelocityMotion.PoseSource.COMMANDS).connected();

    private final ModelDriver bot = robot.bot();

    @ParameterizedTest
    @ValueSource(doubles = {300, -100, 1000})
    void aMoveCoversTheDistanceOfABaseThatFollowsItsVelocities(double mm) {
        MotionReport report = bot.move(mm);

        assertThat(report.amount().number()).isCloseTo(mm, within(5.0));
        assertThat(robot.truePose().xMm()).isCloseTo(mm, within(10.0));
        assertThat(bot.state().pose().xMm()).isCloseTo(report.amount().number(), within(1.0));
    }

    @Test
    void aTurnCoversTheAngle() {
        bot.turn(90);

        assertThat(robot.truePose().headingDeg()).isCloseTo(90, within(2.0));
        assertThat(bot.state().moving()).isFalse();
    }

    @Test
    void aStopIsPublishedSeveralTimes() {
        CompletableFuture<MotionReport> motion = robot.clock.aside(() -> bot.move(1000));
        robot.clock.until(() -> robot.base.mmPerSec() > 100);
        long stoppedMs = robot.base.nowMs();

        bot.stop();

        robot.clock.until(motion::isDone);
        assertThat(robot.base.received().stream().filter(sent -> sent.atMs() >= stoppedMs))
                .hasSizeGreaterThanOrEqualTo(3)
                .allMatch(BaseModel.Command::isZero);
        assertThat(robot.base.mmPerSec()).isZero();
    }

    @Test
    void theReadingsOfAnIdleBaseStayFresh() {
        robot.clock.until(() -> robot.base.nowMs() > 5000);

        assertThat(bot.time().secondsSince(bot.state().atNanos())).isLessThan(1);
    }
}
