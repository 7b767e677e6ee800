package majic.team;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.mockito.ArgumentMatchers.any;
import static org.mockito.Mockito.doThrow;
import static org.mockito.Mockito.mock;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.FakeBot;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.bot.Value;
import majic.driver.Permit;
import majic.driver.PermittedControl;
import majic.drivertest.TestClock;
import majic.time.Signal;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class TeamTest {
    private final TestClock clock = new TestClock();
    private final Team team = new Team(clock.time());
    private final List<String> said = Collections.synchronizedList(new ArrayList<>());

    @AfterEach
    void close() {
        team.close();
        clock.close();
    }

    private FakeBot join() {
        FakeBot bot = FakeBot.on(clock.time());
        bot.connect();
        team.add(bot, OptionalInt.empty());
        return bot;
    }

    private void listen() {
        team.addListener(new TeamListener() {
            @Override
            public void answered(Answer answer) {
                said.add(answer.text());
            }
        });
    }

    private static QueuedCommand move(double mm) {
        String text = "move " + Value.plain(mm);
        return new QueuedCommand(text, true, robot -> List.of(text + ": done (" + robot.move(mm) + ")"));
    }

    private boolean awaitIdle(int robot) throws InterruptedException {
        return team.changes().await(() -> team.member(robot).isIdle(), 100);
    }

    @Test
    void robotsGetTheLowestNumberThatWasNeverUsed() {
        join();
        join();
        team.remove(1);
        join();

        assertThat(team.members()).extracting(Member::number).containsExactly(2, 3);
    }

    @Test
    void aRemovedNumberComesBackWhenAskedFor() {
        join();
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
        join();

        assertThatThrownBy(() -> team.member(7)).hasMessage("7: there is no robot 7 (robots: 1 Fake)");
    }

    @Test
    void commandsToOneRobotRunInTheirOrder() throws InterruptedException {
        join();
        listen();
        team.member(1).submit(move(300), null);
        team.member(1).submit(move(600), null);
        awaitIdle(1);

        assertThat(said).containsExactly("1 move 300: done (300 mm, 1.0 s)", "1 move 600: done (600 mm, 2.0 s)");
    }

    @Test
    void commandsQueuedBehindAFailureAreNotRunAndAnswered() throws InterruptedException {
        join().stallAfter(120);
        listen();
        team.member(1).submit(move(300), null);
        team.member(1).submit(move(100), null);
        awaitIdle(1);

        assertThat(said)
                .containsExactly("1 move 300: failed: stalled after 120 mm", "1 move 100: not run: 1 move 300 failed");
    }

    @Test
    void commandsSubmittedInAnswerToAFailureRun() throws InterruptedException {
        join().stallAfter(120);
        listen();
        team.addListener(new TeamListener() {
            @Override
            public void answered(Answer answer) {
                if (answer.outcome() == Answer.Outcome.FAILED) {
                    team.member(1).submit(new QueuedCommand("get x", false, robot -> List.of("get x: 0")), null);
                }
            }
        });
        team.member(1).submit(move(300), null);
        awaitIdle(1);

        assertThat(said).containsExactly("1 move 300: failed: stalled after 120 mm", "1 get x: 0");
    }

    @Test
    void aStopEndsTheMotionAndEmptiesTheQueue() throws InterruptedException {
        FakeBot bot = join();
        listen();
        team.member(1).submit(move(3000), null);
        team.member(1).submit(move(100), null);
        clock.time().sleep(1);

        team.stop(List.of(team.member(1)), null);
        awaitIdle(1);

        assertThat(said)
                .containsExactlyInAnyOrder("1 move 3000: stopped", "1 move 100: not run: stopped", "1 stop: done");
        assertThat(bot.sent()).containsExactly("move 3000", "halt");
    }

    @Test
    void aCommandSubmittedAfterAStopRunsAfterIt() throws InterruptedException {
        FakeBot bot = join();
        team.member(1).submit(move(3000), null);
        clock.time().sleep(1);

        team.stop(List.of(team.member(1)), null);
        team.member(1).submit(move(50), null);
        awaitIdle(1);

        assertThat(bot.sent()).containsExactly("move 3000", "halt", "move 50");
    }

    @Test
    void aCommandIsSubmittedOnce() throws InterruptedException {
        FakeBot bot = join();
        QueuedCommand move = move(100);
        team.member(1).submit(move, null);

        assertThatThrownBy(() -> team.member(1).submit(move, null)).isInstanceOf(IllegalStateException.class);
        awaitIdle(1);
        assertThat(bot.sent()).containsExactly("move 100");
    }

    @Test
    void stopLatchesUntilReleased() throws InterruptedException {
        FakeBot bot = join();
        team.stopAll();

        assertThatThrownBy(() -> team.member(1).submit(move(100), null)).hasMessageContaining("STOP is latched");
        team.release();
        team.member(1).submit(move(100), null);
        awaitIdle(1);

        assertThat(bot.sent()).containsExactly("halt", "move 100");
    }

    @Test
    void aRobotThatJoinsWhileStopIsLatchedIsLatchedToo() {
        team.stopAll();
        FakeBot bot = join();

        assertThatThrownBy(() -> bot.move(100)).hasMessageContaining("STOP is latched");
    }

    @Test
    void theAnswersToAStopComeInTheOrderOfTheRobotsNumbers() throws InterruptedException {
        join().standAfter(0.2);
        join();
        join().standAfter(0.1);
        listen();

        team.stopAll();
        team.changes().await(() -> said.size() >= 3, 5);

        assertThat(said).containsExactly("1 stop: done", "2 stop: done", "3 stop: done");
    }

    @Test
    void anAnswerDoesNotWaitLongForTheRobotsWithLowerNumbers() throws InterruptedException {
        join().standAfter(0.9);
        join();
        join().standAfter(0.1);
        listen();

        team.stopAll();
        team.changes().await(() -> said.size() >= 3, 5);

        assertThat(said).containsExactly("2 stop: done", "3 stop: done", "1 stop: done");
    }

    @Test
    void stopConfirmsEachRobotAndNamesTheStuckOne() throws InterruptedException {
        join().getStuck();
        join();
        listen();

        team.stopAll();
        team.changes().await(() -> said.size() >= 2, 5);

        assertThat(said).containsExactlyInAnyOrder("1 stop: failed: takes no more data", "2 stop: done");
    }

    @Test
    void anOwnedRobotRefusesMotionFromElsewhere() {
        join();
        Owner act = new Owner(Owner.Kind.ACT, "WanderDog", () -> {});
        team.member(1).claim(act);

        assertThatThrownBy(() -> team.member(1).submit(move(100), null))
                .hasMessage("1 is running WanderDog; \"1 stop\" ends it");
    }

    @Test
    void theTimeOfAnOwnerCountsFromItsFirstClaimAndThatOfABorrowerFromTheLoan() throws InterruptedException {
        join();
        Member robot = team.member(1);
        Owner script = new Owner(Owner.Kind.SCRIPT, "square", () -> {});
        Owner act = new Owner(Owner.Kind.ACT, "WanderDog", () -> {});
        robot.claim(script);
        long claimed = robot.ownedSinceNanos();

        clock.time().signal().await(() -> false, 2);
        robot.claim(script);
        assertThat(robot.ownedSinceNanos()).isEqualTo(claimed);

        robot.lend(act, new Permit(), script);
        assertThat(clock.time().secondsSince(robot.ownedSinceNanos())).isZero();
        robot.takeBack(act);
        assertThat(robot.ownedSinceNanos()).isEqualTo(claimed);
    }

    @Test
    void aStopEndsTheOwner() {
        join();
        List<String> ended = new ArrayList<>();
        team.member(1).claim(new Owner(Owner.Kind.ACT, "WanderDog", () -> ended.add("WanderDog")));

        team.stop(team.members(), null);

        assertThat(ended).containsExactly("WanderDog");
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
    void aRevokedPermitLeavesItsHolderNoUseOfTheRobot() {
        FakeBot bot = join();
        Permit permit = new Permit();
        BotControl control = new PermittedControl(bot, permit);
        permit.revoke(() -> new MotionStopped("revoked"));

        assertThatThrownBy(() -> control.move(100)).hasMessage("revoked");
        assertThatThrownBy(() -> control.get("voltage")).hasMessage("revoked");
        assertThatThrownBy(control::stop).hasMessage("revoked");
        assertThat(bot.sent()).isEmpty();
    }

    @Test
    void aCommandOfBeforeAStopCanReadButNotMove() {
        FakeBot bot = join();
        BotControl control = new PermittedControl(bot, new Permit()).forCommand();
        bot.revokeMotions();

        assertThatThrownBy(() -> control.move(100)).isInstanceOf(MotionStopped.class);
        assertThat(control.get("voltage")).hasToString("12.6 V");
        assertThat(bot.sent()).isEmpty();
    }

    @Test
    void aStopByOneUserOfARobotEndsItsCommandsOnly() {
        FakeBot bot = join();
        PermittedControl control = new PermittedControl(bot, new Permit());
        BotControl queued = control.forCommand();
        BotControl other = new PermittedControl(bot, new Permit()).forCommand();
        control.stop();

        assertThatThrownBy(() -> queued.move(100)).isInstanceOf(MotionStopped.class);
        other.move(100);
        control.move(200);
        assertThat(bot.sent()).containsExactly("halt", "move 100", "move 200");
    }

    @Test
    void aPermitRevokedInAMotionStopsTheRobot() throws InterruptedException {
        FakeBot bot = join();
        Permit lease = new Permit();
        BotControl held = new PermittedControl(bot, lease);
        CompletableFuture<Void> move = clock.aside(() -> {
            held.move(3000);
        });
        clock.time().sleep(1);

        lease.revoke(() -> new MotionStopped("revoked"));
        clock.until(move::isDone);

        assertThat(bot.sent()).containsExactly("move 3000", "halt");
    }

    @Test
    void aFullQueueRefusesACommandAndNamesWhatEmptiesIt() {
        join();
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
        FakeBot bot = join();
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
        join();
        team.member(1).submit(move(3000), null);

        assertThatThrownBy(() -> new ManualControl(team.member(1))).hasMessage("1 is busy; \"1 stop\" ends it");
    }

    @Test
    void aStopThatCannotReachALostRobotIsNotConfirmed() throws InterruptedException {
        join().cut();
        join();
        listen();

        team.stopAll();
        team.changes().await(() -> said.size() >= 2, 5);

        assertThat(said).containsExactlyInAnyOrder("1 stop: failed: connection lost", "2 stop: done");
    }

    @Test
    void anOwnerThatDoesNotEndDelaysNoStopButIsNamedInTheAnswer() throws InterruptedException {
        join();
        join();
        listen();
        team.member(1).claim(new Owner(Owner.Kind.ACT, "WanderDog", () -> {
            throw new IllegalStateException("will not end");
        }));

        team.stopAll();
        team.changes().await(() -> said.size() >= 2 && team.areStopsAnswered(), Signal.FOR_EVER);

        assertThat(said).containsExactly("2 stop: done", "1 stop: stopped, but WanderDog has not given the robot back");
    }

    @Test
    void aCommandThatEndsInAnErrorLeavesTheRobotUsable() throws InterruptedException {
        join();
        listen();
        QueuedCommand broken = new QueuedCommand("wag", true, robot -> {
            throw new AssertionError("a mistake");
        });

        team.member(1).submit(broken, null);
        awaitIdle(1);
        team.member(1).submit(move(300), null);
        awaitIdle(1);

        assertThat(said).hasSize(2).last().isEqualTo("1 move 300: done (300 mm, 1.0 s)");
    }

    @Test
    void aListenerThatBreaksDownDelaysNoStop() throws InterruptedException {
        FakeBot first = join();
        FakeBot second = join();
        team.member(1).submit(move(3000), null);
        team.member(1).submit(move(100), null);
        team.member(2).submit(move(3000), null);
        clock.time().sleep(1);
        TeamListener broken = mock();
        doThrow(new AssertionError("a mistake")).when(broken).answered(any());
        team.addListener(broken);

        team.stopAll();
        assertThat(awaitIdle(1) && awaitIdle(2)).isTrue();

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
        join();

        assertThat(team.stopAllIfAny()).isTrue();

        assertThat(team.isLatched()).isTrue();
    }

    @Test
    void anOwnerThatAStopEndedCanMoveNothingMore() {
        join();
        Owner script = new Owner(Owner.Kind.SCRIPT, "square", () -> {});
        team.member(1).claim(script);
        team.stop(team.members(), null);

        assertThatThrownBy(() -> team.member(1).submit(move(100), script)).isInstanceOf(MotionStopped.class);
    }

    @Test
    void anOwnerThatGaveARobotBackCanMoveItNoMore() {
        join();
        Owner act = new Owner(Owner.Kind.ACT, "WanderDog", () -> {});
        team.member(1).lend(act, new Permit(), null);
        team.member(1).takeBack(act);

        assertThatThrownBy(() -> team.member(1).submit(move(100), act)).isInstanceOf(MotionStopped.class);
    }

    @Test
    void whatABorrowerHadQueuedBeginsNoMoreOnceItsPermitIsRevoked() throws InterruptedException {
        join();
        listen();
        Owner act = new Owner(Owner.Kind.ACT, "WanderDog", () -> {});
        Permit permit = new Permit();
        team.member(1).lend(act, permit, null);
        team.member(1).submit(move(5000), act);
        team.member(1).submit(move(100).checkedBy(permit::check), act);
        clock.time().sleep(0.1);
        permit.revoke(() -> new MotionStopped("called off"));
        clock.time().sleep(1);
        team.member(1).takeBack(act);

        assertThat(said).containsExactly("1 move 5000: stopped");
    }

    /** Lends robot 1 and submits a command of the borrower that sleeps on after its permit was revoked. */
    private QueuedCommand sleepInLoan(Owner borrower, double seconds) throws InterruptedException {
        Permit permit = new Permit();
        QueuedCommand command = new QueuedCommand("sleep", false, robot -> {
            sleep(seconds);
            return List.of();
        });
        team.member(1).lend(borrower, permit, null);
        team.member(1).submit(command, borrower);
        clock.time().sleep(0.1);
        permit.revoke(() -> new MotionStopped("the act has ended"));
        return command;
    }

    private void sleep(double seconds) {
        try {
            clock.time().sleep(seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Test
    void aRobotIsGivenBackWhenTheBorrowersLastCommandHasEnded() throws InterruptedException {
        join();
        Owner act = new Owner(Owner.Kind.ACT, "WanderDog", () -> {});
        QueuedCommand last = sleepInLoan(act, 0.5);
        team.member(1).takeBack(act);

        assertThat(last.hasEnded()).isTrue();
        assertThat(team.member(1).owner()).isNull();
    }

    @Test
    void aRobotIsGivenBackThoughTheBorrowersLastCommandGoesOn() throws InterruptedException {
        join();
        Owner act = new Owner(Owner.Kind.ACT, "WanderDog", () -> {});
        QueuedCommand last = sleepInLoan(act, 100);
        team.member(1).takeBack(act);

        assertThat(last.hasEnded()).isFalse();
        assertThat(team.member(1).owner()).isNull();
        assertThat(clock.time().nanos()).isLessThan(10_000_000_000L);
    }

    @Test
    void aRemovedRobotTakesNoCommands() {
        join();
        Member member = team.member(1);
        team.remove(1);

        assertThatThrownBy(() -> member.submit(move(100), null)).hasMessage("1: robot 1 was removed");
    }

    @Test
    void aRobotThatNoStopReachesIsNotReportedAsStopped() throws InterruptedException {
        FakeBot bot = join();
        listen();
        bot.cut();
        bot.refuse(new BotException("nobody is there"));
        assertThatThrownBy(bot::connect).hasMessage("nobody is there");

        team.stop(team.members(), null);
        awaitIdle(1);

        assertThat(said).containsExactly("1 stop: failed: robot 1 (Fake) is not connected, so no stop can reach it");
    }
}
