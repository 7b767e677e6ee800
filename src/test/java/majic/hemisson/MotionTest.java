package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import majic.bot.Guard;
import majic.bot.MotionFailed;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Motions of a robot that obeys. */
class MotionTest {
    @AutoClose
    private final DrivenHemisson pair = new DrivenHemisson();

    private final ScriptedHemisson robot = pair.robot();
    private final MajicHemisson bot = pair.bot();

    @Test
    void aMoveLastsAsLongAsTheSpeedTableGives() {
        bot.connect();

        MotionReport report = bot.move(42);

        assertThat(report.toString()).startsWith("about 4");
        assertThat(pair.millisBetween("D,3,3", "D,0,0")).isCloseTo(1000, within(150L));
        assertThat(bot.state().pose().xMm()).isCloseTo(42, within(6.0));
        assertThat(bot.state().moving()).isFalse();
    }

    @Test
    void aPositiveAngleTurnsItLeft() {
        bot.connect();

        bot.turn(40);

        assertThat(pair.millisBetween("D,-3,3", "D,0,0")).isCloseTo(748, within(150L));
        assertThat(bot.get("heading").number()).isCloseTo(40, within(8.0));
    }

    @Test
    void theSensorsArePolledWhileItMoves() {
        bot.connect();
        bot.move(42);

        long start = pair.heardAt("D,3,3");
        List<Long> looks = robot.heard().stream()
                .filter(heard -> heard.nanos() > start && heard.nanos() < start + 900_000_000L)
                .map(ScriptedHemisson.Heard::nanos)
                .toList();
        assertThat(looks).hasSizeGreaterThan(8);
    }

    @Test
    void aGuardThatHoldsAlreadyPreventsTheMotion() {
        robot.answer('N', command -> "n,060,004,004,004,004,004,060,080");
        bot.connect();

        bot.move(100, () -> bot.get("distanceFront").number() < 40);

        assertThat(robot.count("D,3,3")).isZero();
    }

    @Test
    void aGuardEndsAMoveAtTheReadingThatShowsIt() {
        bot.connect();
        robot.answer('N', command -> robot.count("D,3,3") == 0 ? DrivenHemisson.FAR : DrivenHemisson.NEAR);

        bot.move(1000, () -> bot.get("distanceFront").number() < 40);

        assertThat(pair.millisBetween("D,3,3", "D,0,0")).isLessThan(500);
    }

    @Test
    void stopEndsAMotion() {
        bot.connect();
        CompletableFuture<Void> stopping = pair.onceItMoves(bot::stop);

        assertThatThrownBy(() -> bot.move(1000)).isInstanceOf(MotionStopped.class);
        robot.clock().join(stopping);
        assertThat(pair.afterMotion()).containsSubsequence("D,0,0", "E");
    }

    @Test
    void aDriveThatIsNotRenewedIsEnded() {
        bot.connect();

        bot.drive(42, 0);
        pair.await(() -> robot.count("D,3,3") == 1 && pair.afterMotion().contains("D,0,0"));

        assertThat(pair.millisBetween("D,3,3", "D,0,0")).isBetween(500L, 900L);
    }

    @Test
    void aTimedDriveReportsItsMotorValues() {
        bot.connect();

        MotionReport report = bot.drive(50, 20, 0.1, Guard.NEVER);

        assertThat(report.toString()).startsWith("motor values 3 and 4: about 53 mm/s, 14 deg/s, 0.");
        assertThat(robot.commands()).contains("D,3,4");
    }

    @Test
    void aTimedDriveThatGoesWrongAfterItsLastRenewalIsNotDone() {
        bot.connect();
        pair.onceItMoves(pair::switchOffAndOn);

        assertThatThrownBy(() -> bot.drive(42, 0, 0.25, Guard.NEVER))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("reset");
    }

    @Test
    void wheelsSetByAnotherSourceEndTheMotion() {
        bot.connect();
        robot.answer('E', command -> "e,00,00");

        assertThatThrownBy(() -> bot.move(1000))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("remote control");
    }
}
