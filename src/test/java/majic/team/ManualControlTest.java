package majic.team;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.mockito.ArgumentMatchers.assertArg;
import static org.mockito.ArgumentMatchers.eq;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.verify;

import java.util.List;
import java.util.OptionalInt;
import majic.bot.FakeBot;
import majic.drivertest.TestClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests manual settings of parameters that move a robot; manual driving is tested in {@link TeamTest}. */
class ManualControlTest {
    private final TestClock clock = new TestClock();
    private final Team team = new Team(clock.time());
    private final TeamListener listener = mock();
    private FakeBot bot;
    private Member member;

    @BeforeEach
    void join() {
        bot = FakeBot.on(clock.time());
        bot.connect();
        member = team.add(bot, OptionalInt.empty());
        team.addListener(listener);
    }

    @AfterEach
    void close() {
        team.close();
        clock.close();
    }

    @Test
    void whatWasSetIsDoneAndThenTheRobotIsFree() throws InterruptedException {
        ManualControl hand = new ManualControl(member);
        hand.set("headPan", 10);
        hand.finish();

        assertThat(team.changes().await(hand::isOff, 5)).isTrue();
        assertThat(bot.sent()).containsExactly("headPan 10");
        assertThat(member.owner()).isNull();
        assertThat(hand.set("headPan", 20)).isFalse();
    }

    @Test
    void aRobotUnderManualControlRefusesOtherSources() {
        ManualControl hand = new ManualControl(member);

        assertThatThrownBy(() -> member.check(true, null)).hasMessageContaining("driven by hand");
        assertThatThrownBy(() -> new ManualControl(member)).hasMessageContaining("driven by hand");
        hand.close();
    }

    @Test
    void aStopEndsTheHandForGood() throws InterruptedException {
        ManualControl hand = new ManualControl(member);
        team.stop(List.of(member), null);

        assertThat(team.changes().await(hand::isOff, 5)).isTrue();
        assertThat(hand.set("headPan", 20)).isFalse();
        assertThat(bot.sent()).doesNotContain("headPan 20");
    }

    @Test
    void noDriveFollowsAStopOfTheRobotItself() throws InterruptedException {
        ManualControl hand = new ManualControl(member);
        bot.stop();
        hand.drive(100, 0);

        assertThat(team.changes().await(hand::isOff, 5)).isTrue();
        assertThat(bot.sent()).noneMatch(sent -> sent.startsWith("drive"));
    }

    @Test
    void manualControlIsRefusedWhileStopIsLatched() {
        team.stopAll();

        assertThatThrownBy(() -> new ManualControl(member)).hasMessageContaining("STOP is latched");
    }

    @Test
    void anErrorIsReportedAndReleasesTheRobot() throws InterruptedException {
        ManualControl hand = new ManualControl(member);
        hand.set("headPan", 500);

        assertThat(team.changes().await(hand::isOff, 5)).isTrue();
        verify(listener)
                .noticed(
                        eq(1),
                        assertArg(text -> assertThat(text).startsWith("1: ").contains("headPan")));
    }

    @Test
    void aRobotKnowsItsPlaceInTheTeam() {
        assertThat(Member.of(bot)).contains(member);
        assertThat(Member.of(FakeBot.on(clock.time()))).isEmpty();
    }
}
