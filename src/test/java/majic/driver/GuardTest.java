package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.mockito.Mockito.doReturn;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.never;
import static org.mockito.Mockito.verify;
import static org.mockito.Mockito.when;

import java.util.List;
import java.util.Optional;
import majic.bot.BotListener;
import majic.bot.FakeBot;
import majic.bot.Guard;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.drivertest.TestClock;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** A guard of a motion may ask anything; whatever that throws is no trouble of the robot that moves. */
class GuardTest {
    @AutoClose
    private final SteppedBot stepped = new SteppedBot();

    private final TestClock clock = stepped.clock;
    private final FakeBot bot = stepped.bot;

    @Test
    void anotherRobotsLostLinkIsNotItsOwn() {
        Guard asksAnother = () -> {
            throw new LinkLost("the other one is gone");
        };

        assertThatThrownBy(() -> bot.move(500, asksAnother))
                .isInstanceOf(MotionFailed.class)
                .hasMessage("the other one is gone");
        assertThat(bot.isConnected()).isTrue();
        assertThat(bot.sent()).endsWith("halt");
    }

    @Test
    void oneThatWatchesAnotherRobotTakesNoneOfItsNotices() {
        FakeBot other = FakeBot.on(clock.time());
        other.connect();
        Guard watchesOther = mock();
        doReturn(List.of(other)).when(watchesOther).alsoWatches();
        when(watchesOther.reached()).then(call -> {
            other.notice("the switches are wrong");
            return true;
        });
        BotListener listener = mock();

        bot.move(500, watchesOther);
        other.addListener(listener);

        verify(listener).notice(other, "the switches are wrong");
    }

    @Test
    void oneThatCannotSayWhatItWatchesHoldsUpNoLaterMotion() {
        Guard broken = mock();
        when(broken.alsoWatches()).thenThrow(new IllegalStateException("a mistake"));

        assertThatThrownBy(() -> bot.move(500, broken)).hasMessage("a mistake");
        assertThat(bot.isBusy()).isFalse();
        assertThat(bot.move(300).toString()).startsWith("300 mm");
    }

    @Test
    void oneThatIsHandedOverToTheRobotIsNotEvaluatedAnyMore() {
        Guard guard = mock();
        when(guard.text()).thenReturn(Optional.of("distanceFront < 300"));
        when(guard.reached()).thenReturn(true);
        bot.handsGuardsOver();

        assertThat(bot.move(300, guard).toString()).startsWith("300 mm");
        assertThat(bot.sent()).contains("until distanceFront < 300");
        verify(guard, never()).reached();
    }
}
