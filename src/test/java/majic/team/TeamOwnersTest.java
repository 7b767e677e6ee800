package majic.team;

import static majic.team.TeamFixture.move;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import majic.bot.BotControl;
import majic.bot.FakeBot;
import majic.bot.MotionStopped;
import majic.driver.Permit;
import majic.driver.PermittedControl;
import majic.drivertest.TestClock;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests which owner may command a robot of a team, and for how long. */
class TeamOwnersTest {
    @AutoClose
    private final TeamFixture fixture = new TeamFixture();

    private final Team team = fixture.team;
    private final TestClock clock = fixture.clock;
    private final List<String> said = fixture.said;

    @Test
    void anOwnedRobotRefusesMotionFromElsewhere() {
        fixture.join();
        Owner act = new Owner(Owner.Kind.ACT, "WanderDog", () -> {});
        team.member(1).claim(act);

        assertThatThrownBy(() -> team.member(1).submit(move(100), null))
                .hasMessage("1 is running WanderDog; \"1 stop\" ends it");
    }

    @Test
    void theTimeOfAnOwnerCountsFromItsFirstClaimAndThatOfABorrowerFromTheLoan() throws InterruptedException {
        fixture.join();
        Member robot = team.member(1);
        Owner script = new Owner(Owner.Kind.SCRIPT, "square", () -> {});
        Owner act = new Owner(Owner.Kind.ACT, "WanderDog", () -> {});
        robot.claim(script);
        long claimed = robot.ownedSinceNanos();

        clock.time().signal().await(() -> false, 2);
        robot.claim(script);
        assertThat(robot.ownedSinceNanos()).isEqualTo(claimed);

        robot.sublet(act, script);
        assertThat(clock.time().secondsSince(robot.ownedSinceNanos())).isZero();
        robot.endSublease(act);
        assertThat(robot.ownedSinceNanos()).isEqualTo(claimed);
    }

    @Test
    void aStopEndsTheOwner() {
        fixture.join();
        List<String> ended = new ArrayList<>();
        team.member(1).claim(new Owner(Owner.Kind.ACT, "WanderDog", () -> ended.add("WanderDog")));

        team.stop(team.members(), null);

        assertThat(ended).containsExactly("WanderDog");
    }

    @Test
    void aRevokedPermitLeavesItsHolderNoUseOfTheRobot() {
        FakeBot bot = fixture.join();
        Permit permit = new Permit();
        BotControl control = new PermittedControl(bot, permit);
        permit.revoke(() -> new MotionStopped("revoked"));

        assertThatThrownBy(() -> control.move(100)).hasMessage("revoked");
        assertThatThrownBy(() -> control.get("voltage")).hasMessage("revoked");
        assertThatThrownBy(control::stop).hasMessage("revoked");
        assertThat(bot.sent()).isEmpty();
    }

    @Test
    void aStopByOneUserOfARobotEndsItsCommandsOnly() {
        FakeBot bot = fixture.join();
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
        FakeBot bot = fixture.join();
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
    void anOwnerThatAStopEndedCanMoveNothingMore() {
        fixture.join();
        Owner script = new Owner(Owner.Kind.SCRIPT, "square", () -> {});
        team.member(1).claim(script);
        team.stop(team.members(), null);

        assertThatThrownBy(() -> team.member(1).submit(move(100), script)).isInstanceOf(MotionStopped.class);
    }

    @Test
    void anOwnerThatGaveARobotBackCanMoveItNoMore() {
        fixture.join();
        Owner act = new Owner(Owner.Kind.ACT, "WanderDog", () -> {});
        team.member(1).sublet(act, null);
        team.member(1).endSublease(act);

        assertThatThrownBy(() -> team.member(1).submit(move(100), act)).isInstanceOf(MotionStopped.class);
    }

    @Test
    void whatAnActHadQueuedBeginsNoMoreOnceItsPermitIsRevoked() throws InterruptedException {
        fixture.join();
        fixture.listen();
        Owner act = new Owner(Owner.Kind.ACT, "WanderDog", () -> {});
        team.member(1).sublet(act, null);
        team.member(1).submit(move(5000), act);
        team.member(1).submit(move(100).checkedBy(act.permit()::check), act);
        clock.time().sleep(0.1);
        act.permit().revoke(() -> new MotionStopped("called off"));
        clock.time().sleep(1);
        team.member(1).endSublease(act);

        assertThat(said).containsExactly("1 move 5000: stopped");
    }

    /** Sublets robot 1 and submits a command of the act that sleeps on after its permit was revoked. */
    private QueuedCommand sleepInSublease(Owner act, double seconds) throws InterruptedException {
        QueuedCommand command = new QueuedCommand("sleep", false, robot -> {
            sleep(seconds);
            return List.of();
        });
        team.member(1).sublet(act, null);
        team.member(1).submit(command, act);
        clock.time().sleep(0.1);
        act.permit().revoke(() -> new MotionStopped("the act has ended"));
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
    void aRobotIsGivenBackWhenTheLastCommandOfTheActHasEnded() throws InterruptedException {
        fixture.join();
        Owner act = new Owner(Owner.Kind.ACT, "WanderDog", () -> {});
        QueuedCommand last = sleepInSublease(act, 0.5);
        team.member(1).endSublease(act);

        assertThat(last.hasEnded()).isTrue();
        assertThat(team.member(1).owner()).isNull();
    }

    @Test
    void aRobotIsGivenBackThoughTheLastCommandOfTheActGoesOn() throws InterruptedException {
        fixture.join();
        Owner act = new Owner(Owner.Kind.ACT, "WanderDog", () -> {});
        QueuedCommand last = sleepInSublease(act, 100);
        team.member(1).endSublease(act);

        assertThat(last.hasEnded()).isFalse();
        assertThat(team.member(1).owner()).isNull();
        assertThat(clock.time().nanos()).isLessThan(10_000_000_000L);
    }
}
