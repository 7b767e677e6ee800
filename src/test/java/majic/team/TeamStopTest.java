package majic.team;

import static majic.team.TeamFixture.move;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.mockito.ArgumentMatchers.any;
import static org.mockito.Mockito.doThrow;
import static org.mockito.Mockito.mock;

import java.util.List;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.FakeBot;
import majic.bot.MotionStopped;
import majic.driver.Permit;
import majic.driver.PermittedControl;
import majic.drivertest.TestClock;
import majic.time.Signal;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests what a stop, and STOP of all robots, ends, latches and reports. */
class TeamStopTest {
    private static final String REMEDY = "; if it is at rest, \"remove 1\" ends this alarm; \"add ADDRESS as 1\""
            + " connects it under another address";

    @AutoClose
    private final TeamFixture fixture = new TeamFixture();

    private final Team team = fixture.team;
    private final TestClock clock = fixture.clock;
    private final List<String> said = fixture.said;

    @Test
    void aStopEndsTheMotionAndEmptiesTheQueue() throws InterruptedException {
        FakeBot bot = fixture.join();
        fixture.listen();
        team.member(1).submit(move(3000), null);
        team.member(1).submit(move(100), null);
        clock.time().sleep(1);

        team.stop(List.of(team.member(1)), null);
        fixture.awaitIdle(1);

        assertThat(said)
                .containsExactlyInAnyOrder("1 move 3000: stopped", "1 move 100: not run: stopped", "1 stop: done");
        assertThat(bot.sent()).containsExactly("move 3000", "halt");
    }

    @Test
    void aQueuedCommandThatAStopRemovesEndsAsStopped() throws InterruptedException {
        fixture.join();
        QueuedCommand queued = move(100);
        team.member(1).submit(move(3000), null);
        team.member(1).submit(queued, null);
        clock.time().sleep(1);

        team.stop(List.of(team.member(1)), null);
        fixture.awaitIdle(1);

        assertThat(queued.outcome()).isEqualTo(Answer.Outcome.STOPPED);
    }

    @Test
    void aCommandSubmittedAfterAStopRunsAfterIt() throws InterruptedException {
        FakeBot bot = fixture.join();
        team.member(1).submit(move(3000), null);
        clock.time().sleep(1);

        team.stop(List.of(team.member(1)), null);
        team.member(1).submit(move(50), null);
        fixture.awaitIdle(1);

        assertThat(bot.sent()).containsExactly("move 3000", "halt", "move 50");
    }

    @Test
    void stopLatchesUntilReleased() throws InterruptedException {
        FakeBot bot = fixture.join();
        team.stopAll();

        assertThatThrownBy(() -> team.member(1).submit(move(100), null)).hasMessageContaining("STOP is latched");
        team.release();
        team.member(1).submit(move(100), null);
        fixture.awaitIdle(1);

        assertThat(bot.sent()).containsExactly("halt", "move 100");
    }

    @Test
    void aRobotThatJoinsWhileStopIsLatchedIsLatchedToo() {
        team.stopAll();
        FakeBot bot = fixture.join();

        assertThatThrownBy(() -> bot.move(100)).hasMessageContaining("STOP is latched");
    }

    @Test
    void theAnswersToAStopComeInTheOrderOfTheRobotsNumbers() throws InterruptedException {
        fixture.join().standAfter(1.2);
        fixture.join();
        fixture.join().standAfter(0.1);
        fixture.listen();

        team.stopAll();
        team.changes().await(() -> said.size() >= 3, 5);

        assertThat(said).containsExactly("1 stop: done", "2 stop: done", "3 stop: done");
    }

    @Test
    void anAnswerDoesNotWaitLongForTheRobotsWithLowerNumbers() throws InterruptedException {
        fixture.join().standAfter(2.9);
        fixture.join();
        fixture.join().standAfter(0.1);
        fixture.listen();

        team.stopAll();
        team.changes().await(() -> said.size() >= 3, 5);

        assertThat(said).containsExactly("2 stop: done", "3 stop: done", "1 stop: done");
    }

    @Test
    void stopConfirmsEachRobotAndNamesTheStuckOne() throws InterruptedException {
        fixture.join().getStuck();
        fixture.join();
        fixture.listen();

        team.stopAll();
        team.changes().await(() -> said.size() >= 2, 5);

        assertThat(said).containsExactlyInAnyOrder("1 stop: failed: takes no more data", "2 stop: done");
    }

    @Test
    void aCommandOfBeforeAStopCanReadButNotMove() {
        FakeBot bot = fixture.join();
        BotControl control = new PermittedControl(bot, new Permit()).forCommand();
        bot.revokeMotions();

        assertThatThrownBy(() -> control.move(100)).isInstanceOf(MotionStopped.class);
        assertThat(control.get("voltage")).hasToString("12.6 V");
        assertThat(bot.sent()).isEmpty();
    }

    @Test
    void aStopThatCannotReachALostRobotIsNotConfirmed() throws InterruptedException {
        fixture.join().cut();
        fixture.join();
        fixture.listen();

        team.stopAll();
        team.changes().await(() -> said.size() >= 2, 5);

        assertThat(said).containsExactlyInAnyOrder("1 stop: failed: connection lost" + REMEDY, "2 stop: done");
    }

    @Test
    void anOwnerThatDoesNotEndDelaysNoStopButIsNamedInTheAnswer() throws InterruptedException {
        fixture.join();
        fixture.join();
        fixture.listen();
        team.member(1).claim(new Owner(Owner.Kind.ACT, "WanderDog", () -> {
            throw new IllegalStateException("will not end");
        }));

        team.stopAll();
        team.changes().await(() -> said.size() >= 2 && team.areStopsAnswered(), Signal.FOR_EVER);

        assertThat(said).containsExactly("2 stop: done", "1 stop: stopped, but WanderDog has not given the robot back");
    }

    @Test
    void aListenerThatBreaksDownDelaysNoStop() throws InterruptedException {
        FakeBot first = fixture.join();
        FakeBot second = fixture.join();
        team.member(1).submit(move(3000), null);
        team.member(1).submit(move(100), null);
        team.member(2).submit(move(3000), null);
        clock.time().sleep(1);
        TeamListener broken = mock();
        doThrow(new AssertionError("a mistake")).when(broken).answered(any());
        team.addListener(broken);

        team.stopAll();
        assertThat(fixture.awaitIdle(1) && fixture.awaitIdle(2)).isTrue();

        assertThat(first.sent()).containsExactly("move 3000", "halt");
        assertThat(second.sent()).containsExactly("move 3000", "halt");
    }

    @Test
    void withoutARobotStopIsCountedAndDoesNotLatch() {
        assertThat(team.stopAllIfAny()).isFalse();

        assertThat(team.isLatched()).isFalse();
        assertThat(team.stops().all()).isEqualTo(1);
    }

    @Test
    void withARobotStopLatches() {
        fixture.join();

        assertThat(team.stopAllIfAny()).isTrue();

        assertThat(team.isLatched()).isTrue();
    }

    @Test
    void aRobotThatNoStopReachesIsNotReportedAsStopped() throws InterruptedException {
        FakeBot bot = fixture.join();
        fixture.listen();
        bot.cut();
        bot.refuse(new BotException("nobody is there"));
        assertThatThrownBy(bot::connect).hasMessage("nobody is there");

        team.stop(team.members(), null);
        fixture.awaitIdle(1);

        assertThat(said)
                .containsExactly("1 stop: failed: robot 1 (Fake) is not connected, so no stop can reach it" + REMEDY);
    }
}
