package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** A robot that misses answers, is reset, falls silent or is cut off, above all in motion. */
class LostRobotTest {
    @AutoClose
    private final DrivenHemisson pair = new DrivenHemisson();

    private final ScriptedHemisson robot = pair.robot();
    private final MajicHemisson bot = pair.bot();

    @Test
    void fromTheFirstMissedAnswerInMotionTheStopIsRepeated() {
        bot.connect();
        pair.fallSilentWhenMoving();

        assertThatThrownBy(() -> bot.move(1000)).isInstanceOf(BotException.class);
        pair.await(() -> robot.count("D,0,0") >= 4);

        assertThat(pair.afterMotion())
                .filteredOn(command -> command.startsWith("D"))
                .startsWith("D")
                .allMatch(command -> command.equals("D") || command.equals("D,0,0"));
        assertThat(pair.notices()).anyMatch(notice -> notice.contains("lift it"));
    }

    @Test
    void afterAMissedAnswerTheStopIsVerifiedAndTheMotionFails() {
        bot.connect();
        robot.answer('N', command -> pair.isMoving() ? "noise" : DrivenHemisson.FAR);

        assertThatThrownBy(() -> bot.move(1000))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("missed");

        assertThat(pair.afterMotion()).containsSubsequence("D,0,0", "E");
        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void aLostRobotThatConfirmsTheStopIsClosedWithoutAnAlarm() {
        bot.connect();
        pair.fallSilentWhenMoving();
        assertThatThrownBy(() -> bot.move(1000)).isInstanceOf(BotException.class);
        pair.await(() -> !bot.isConnected());
        robot.answer('D', robot::setSpeeds);
        robot.fallSilent(false);
        pair.await(() -> pair.notices().stream().anyMatch(notice -> notice.contains("answers again and has stopped")));

        bot.close();

        assertThat(pair.notices()).noneMatch(notice -> notice.contains("has not confirmed"));
    }

    @Test
    void aStopThatIsConfirmedWhileTheConnectionIsClosedIsDone() {
        bot.connect();
        bot.drive(42, 0);
        pair.await(pair::isMoving);
        AtomicReference<CompletableFuture<Void>> closing = new AtomicReference<>();
        robot.answer('E', command -> {
            closing.compareAndSet(null, robot.clock().aside(bot::close));
            return "e,00,00";
        });

        bot.stop();

        robot.clock().join(closing.get());
        assertThat(pair.notices()).noneMatch(notice -> notice.contains("confirmed"));
    }

    @Test
    void aLastingSilenceIsReportedWithItsCause() {
        bot.connect();
        robot.fallSilent(true);

        pair.await(() -> !bot.isConnected());

        assertThatThrownBy(() -> bot.move(10)).isInstanceOf(LinkLost.class).hasMessageContaining("wait 5 s");
    }

    @Test
    void aLinkCutWhileItMovesIsReportedWithTheRemedy() {
        bot.connect();
        pair.onceItMoves(pair::hangUp);

        assertThatThrownBy(() -> bot.move(1000)).isInstanceOf(LinkLost.class).hasMessageContaining("lift it");
    }

    @Test
    void aLostRobotIsConnectedAgain() throws Exception {
        bot.connect();
        robot.hangUp();
        pair.await(() -> !bot.isConnected());

        bot.connect();

        bot.move(5);
        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void aResetInMidMotionEndsIt() {
        bot.connect();
        pair.onceItMoves(pair::switchOffAndOn);

        assertThatThrownBy(() -> bot.move(1000))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("reset");
    }

    @Test
    void aStopInWhichTheConnectionIsLostIsNotConfirmed() {
        bot.connect();
        robot.answer('D', command -> robot.hangUpInsteadOfAnswering());

        assertThatThrownBy(bot::stop).isInstanceOf(BotException.class).hasMessageContaining("lost");
    }
}
