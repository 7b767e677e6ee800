package majic.team;

import static majic.team.TeamFixture.move;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.mockito.Mockito.mock;

import java.util.List;
import java.util.OptionalInt;
import majic.bot.BotException;
import majic.bot.FakeBot;
import majic.bot.MajicBot;
import majic.drivertest.TestClock;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests the numbers of the robots of a team, and the commands that wait in their queues. */
class TeamTest {
    @AutoClose
    private final TeamFixture fixture = new TeamFixture();

    private final Team team = fixture.team;
    private final TestClock clock = fixture.clock;
    private final List<String> said = fixture.said;

    @Test
    void robotsGetTheLowestNumberThatWasNeverUsed() {
        fixture.join();
        fixture.join();
        team.remove(1);
        fixture.join();

        assertThat(team.members()).extracting(Member::number).containsExactly(2, 3);
    }

    @Test
    void aRemovedNumberComesBackWhenAskedFor() {
        fixture.join();
        team.remove(1);
        FakeBot bot = FakeBot.on(clock.time());
        bot.connect();

        assertThat(team.add(bot, OptionalInt.of(1)).number()).isEqualTo(1);
    }

    @Test
    void aTeamIsNeverLargerThanItsMaximum() {
        Team pair = new Team(clock.time(), 2);
        pair.add(FakeBot.on(clock.time()), OptionalInt.empty());
        pair.add(FakeBot.on(clock.time()), OptionalInt.empty());

        assertThatThrownBy(() -> pair.add(FakeBot.on(clock.time()), OptionalInt.empty()))
                .hasMessageContaining("the team is full (2 robots)");
    }

    @Test
    void aTeamHasRoomForAThousandRobotsAtMost() {
        assertThat(new Team(clock.time(), 1000).maxBots()).isEqualTo(1000);
        assertThatThrownBy(() -> new Team(clock.time(), 1001))
                .hasMessage("a team has room for 1 to 1000 robots, not 1001");
    }

    @Test
    void aMissingRobotIsNamedWithThoseThereAre() {
        fixture.join();

        assertThatThrownBy(() -> team.member(7)).hasMessage("7: there is no robot 7 (robots: 1 Fake)");
    }

    @Test
    void commandsToOneRobotRunInTheirOrder() throws InterruptedException {
        fixture.join();
        fixture.listen();
        team.member(1).submit(move(300), null);
        team.member(1).submit(move(600), null);
        fixture.awaitIdle(1);

        assertThat(said).containsExactly("1 move 300: done (300 mm, 1.0 s)", "1 move 600: done (600 mm, 2.0 s)");
    }

    @Test
    void commandsQueuedBehindAFailureAreNotRunAndAnswered() throws InterruptedException {
        fixture.join().stallAfter(120);
        fixture.listen();
        team.member(1).submit(move(300), null);
        team.member(1).submit(move(100), null);
        fixture.awaitIdle(1);

        assertThat(said)
                .containsExactly("1 move 300: failed: stalled after 120 mm", "1 move 100: not run: 1 move 300 failed");
    }

    @Test
    void commandsSubmittedInAnswerToAFailureRun() throws InterruptedException {
        fixture.join().stallAfter(120);
        fixture.listen();
        team.addListener(new TeamListener() {
            @Override
            public void answered(Answer answer) {
                if (answer.outcome() == Answer.Outcome.FAILED) {
                    team.member(1).submit(new QueuedCommand("get x", false, robot -> List.of("get x: 0")), null);
                }
            }
        });
        team.member(1).submit(move(300), null);
        fixture.awaitIdle(1);

        assertThat(said).containsExactly("1 move 300: failed: stalled after 120 mm", "1 get x: 0");
    }

    @Test
    void aCommandIsSubmittedOnce() throws InterruptedException {
        FakeBot bot = fixture.join();
        QueuedCommand move = move(100);
        team.member(1).submit(move, null);

        assertThatThrownBy(() -> team.member(1).submit(move, null)).isInstanceOf(IllegalStateException.class);
        fixture.awaitIdle(1);
        assertThat(bot.sent()).containsExactly("move 100");
    }

    @Test
    void aRobotWithoutADriverOfMajicIsRefusedWithTheClassItWouldHaveToExtend() {
        MajicBot stranger = mock(MajicBot.class);

        assertThatThrownBy(() -> team.add(stranger, OptionalInt.empty()))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("does not extend majic.driver.BotDriver");
        assertThat(team.members()).isEmpty();
    }

    @Test
    void aFullQueueRefusesACommandAndNamesWhatEmptiesIt() {
        fixture.join();
        int oneUnderWayAndOneTooMany = CommandQueue.DEPTH + 2;
        assertThatThrownBy(() -> {
                    for (int count = 0; count < oneUnderWayAndOneTooMany; count++) {
                        team.member(1).submit(move(5000), null);
                    }
                })
                .hasMessageContaining("its queue is full (100");
    }

    @Test
    void manualControlThatIsNotRenewedStopsTheRobot() throws InterruptedException {
        FakeBot bot = fixture.join();
        ManualControl hand = new ManualControl(team.member(1));
        hand.drive(200, 0);
        clock.time().sleep(1);

        assertThat(bot.sent()).containsExactly("drive 200 0", "halt");
        hand.close();
        assertThat(team.changes().await(() -> team.member(1).owner() == null, 1))
                .isTrue();
    }

    @Test
    void aHandIsRefusedWhileTheRobotIsBusy() {
        fixture.join();
        team.member(1).submit(move(3000), null);

        assertThatThrownBy(() -> new ManualControl(team.member(1))).hasMessage("1 is busy; \"1 stop\" ends it");
    }

    @Test
    void aCommandThatEndsInAnErrorLeavesTheRobotUsable() throws InterruptedException {
        fixture.join();
        fixture.listen();
        QueuedCommand broken = new QueuedCommand("wag", true, robot -> {
            throw new AssertionError("a mistake");
        });

        team.member(1).submit(broken, null);
        fixture.awaitIdle(1);
        team.member(1).submit(move(300), null);
        fixture.awaitIdle(1);

        assertThat(said).hasSize(2).last().isEqualTo("1 move 300: done (300 mm, 1.0 s)");
    }

    @Test
    void aRemovedRobotTakesNoCommands() {
        fixture.join();
        Member member = team.member(1);
        team.remove(1);

        assertThatThrownBy(() -> member.submit(move(100), null)).hasMessage("1: robot 1 was removed");
    }
}
