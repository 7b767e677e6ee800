package majic.velocity;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** The velocities that are published during motions and drives: how often, and how they change. */
class VelocityProfileTest {
    private static final double ACCELERATION = BaseDynamics.of(
                    ModelDriver.FASTEST_MM_PER_SEC, ModelDriver.FASTEST_DEG_PER_SEC, 1)
            .accelerationMmPerSec2();

    @AutoClose
    private final ModelRobot robot = new ModelRobot(BaseModel.Traits.USUAL).connected();

    private final ModelDriver bot = robot.bot();

    @Test
    void aMovePublishesTwentyVelocitiesASecondWithLimitedChanges() {
        bot.move(600);

        assertSmooth(robot.base.received(), 150);
    }

    @Test
    void aDriveGainsSpeedWithLimitedChangesAndIsRepeatedUntilItLapses() {
        bot.drive(200, 0);
        robot.clock.until(() -> robot.base.nowMs() > 550);
        List<BaseModel.Command> driven = robot.base.received();

        assertSmooth(driven, 200);
        assertThat(driven).hasSizeBetween(9, 13);

        robot.clock.until(() -> robot.base.nowMs() > 1500);
        List<BaseModel.Command> all = robot.base.received();
        assertThat(all.subList(all.size() - 3, all.size())).allMatch(BaseModel.Command::isZero);
        assertThat(all.get(all.size() - 1).atMs()).isLessThan(1300);
    }

    @Test
    void aDriveThatIsReversedPassesThroughZero() {
        bot.drive(200, 0);
        robot.clock.until(() -> robot.base.mmPerSec() > 150);
        bot.drive(-200, 0);
        robot.clock.until(() -> robot.base.mmPerSec() < -50);

        assertSmooth(robot.base.received(), 200);
        bot.stop();
    }

    private static void assertSmooth(List<BaseModel.Command> sent, double cruise) {
        assertThat(sent).allMatch(one -> Math.abs(one.mmPerSec()) <= cruise + 1e-9);
        assertThat(sent).anyMatch(one -> Math.abs(one.mmPerSec()) > 0.6 * cruise);
        IntStream.range(1, sent.size()).forEach(i -> {
            BaseModel.Command before = sent.get(i - 1);
            BaseModel.Command now = sent.get(i);
            double seconds = (now.atMs() - before.atMs()) / 1e3;
            assertThat(seconds).as("time between two velocities").isLessThanOrEqualTo(0.056);
            boolean gains = Math.abs(now.mmPerSec()) > Math.abs(before.mmPerSec());
            double most = (gains ? 1 : 2) * ACCELERATION * 0.056;
            assertThat(Math.abs(now.mmPerSec() - before.mmPerSec()))
                    .as("change after " + before)
                    .isLessThan(most + 15);
        });
    }
}
