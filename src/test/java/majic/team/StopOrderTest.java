package majic.team;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import majic.bot.BotListener;
import majic.bot.FakeBot;
import majic.bot.MotionReport;
import majic.bot.Unit;
import majic.bot.Value;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Tests that a stop revokes, writes to every connection, and only then notifies: a callback that never returns delays
 * no byte.
 */
class StopOrderTest {
    private final Team team = new Team(TimeSource.system());
    private final Gate gate = Gate.closed();
    private final FakeBot first = FakeBot.on(TimeSource.system());
    private final FakeBot second = FakeBot.on(TimeSource.system());

    @BeforeEach
    void connect() {
        for (FakeBot bot : List.of(first, second)) {
            bot.connect();
            team.add(bot, OptionalInt.empty());
        }
    }

    @AfterEach
    void close() {
        gate.open();
        team.close();
    }

    private static void awaitSent(String command, FakeBot... bots) {
        for (FakeBot bot : bots) {
            WaitLimit.until(command, () -> bot.sent().contains(command));
        }
    }

    /** Runs on a thread of its own, because it may block. */
    private static void aside(Runnable work) {
        CompletableFuture.runAsync(work, task -> new Thread(task).start());
    }

    private static QueuedCommand move() {
        return new QueuedCommand("move 3000", true, robot -> List.of(robot.move(3000) + ""));
    }

    private void moveBothWithACommandWaiting() {
        for (Member member : team.members()) {
            member.submit(move(), null);
            member.submit(move(), null);
        }
        awaitSent("move 3000", first, second);
    }

    @Test
    void aListenerThatBlocksDelaysNoByteOfStopAllNorItsCaller() {
        moveBothWithACommandWaiting();
        team.addListener(gate.blocked(TeamListener.class));

        team.stopAll();

        awaitSent("halt", first, second);
    }

    @Test
    void aListenerThatBlocksDelaysNoByteOfAStopNorItsCaller() {
        moveBothWithACommandWaiting();
        team.addListener(gate.blocked(TeamListener.class));

        team.stop(team.members(), null);

        awaitSent("halt", first, second);
    }

    @Test
    void aListenerThatBlocksDelaysNoByteOfTheTeamsEnd() {
        moveBothWithACommandWaiting();
        team.addListener(gate.blocked(TeamListener.class));

        aside(team::close);

        awaitSent("close", first, second);
    }

    @Test
    void aListenerThatBlocksDelaysNoByteToARobotThatIsRemoved() {
        moveBothWithACommandWaiting();
        team.addListener(gate.blocked(TeamListener.class));

        aside(() -> team.remove(1));

        awaitSent("close", first);
    }

    @Test
    void anOwnerThatDoesNotReturnDelaysNoByte() {
        team.member(1).claim(new Owner(Owner.Kind.ACT, "WanderDog", gate::pass));

        team.stop(team.members(), null);

        awaitSent("halt", first, second);
    }

    @Test
    void anOwnerThatDoesNotReturnDelaysNoOtherOwnersEnd() {
        List<String> ended = new CopyOnWriteArrayList<>();
        team.member(1).claim(new Owner(Owner.Kind.ACT, "WanderDog", gate::pass));
        team.member(2).claim(new Owner(Owner.Kind.ACT, "Guard", () -> ended.add("Guard")));
        team.addListener(gate.blocked(TeamListener.class));

        team.stopAll();

        WaitLimit.until("the end of the act", () -> ended.contains("Guard"));
    }

    @Test
    void aRobotsListenerThatBlocksDelaysNoByteToIt() {
        first.addListener(gate.blocked(BotListener.class));
        first.sendDrivesThrough(() -> first.notice("motors on"));
        aside(() -> first.drive(100, 0));
        awaitSent("drive 100 0", first);

        team.stopAll();

        awaitSent("halt", first, second);
    }

    @Test
    void aRobotsListenerThatBlocksDelaysNoClosing() {
        first.addListener(gate.blocked(BotListener.class));

        aside(first::close);

        awaitSent("close", first);
    }

    @Test
    void aDriveExpiresThoughAListenerBlocksTheRobotsTimer() {
        first.addListener(gate.blocked(BotListener.class));
        first.every("report", 0.01, () -> first.tell("voltage", Value.of(11, Unit.V)));

        first.drive(100, 0);

        awaitSent("halt", first);
    }

    @Test
    void aMotionEndsWithTheLinkThoughAListenerOfTheLossBlocks() {
        CompletableFuture<MotionReport> move =
                CompletableFuture.supplyAsync(() -> first.move(3000), task -> new Thread(task).start());
        awaitSent("move 3000", first);
        first.addListener(gate.blocked(BotListener.class));

        aside(first::cut);

        WaitLimit.until("the end of the move", move::isCompletedExceptionally);
    }

    @Test
    void aLostLinkEndsTheActOnAllItsRobotsThoughListenersBlock() {
        List<String> ended = new CopyOnWriteArrayList<>();
        Owner act = new Owner(Owner.Kind.ACT, "Guard", () -> ended.add("Guard"));
        team.members().forEach(member -> member.sublet(act, null));
        first.addListener(gate.blocked(BotListener.class));
        team.addListener(gate.blocked(TeamListener.class));

        aside(first::cut);

        WaitLimit.until("the end of the act", () -> ended.contains("Guard"));
        assertThat(act.isRevoked()).isTrue();
    }

    @Test
    void aListenerThatBlocksDoesNotKeepTheAnswersFromTheOthers() {
        List<Integer> answered = new CopyOnWriteArrayList<>();
        team.addListener(gate.blocked(TeamListener.class));
        team.addListener(new TeamListener() {
            @Override
            public void answered(Answer answer) {
                answered.add(answer.robot());
            }
        });

        team.stopAll();

        WaitLimit.until("both answers", () -> answered.containsAll(List.of(1, 2)));
    }

    @Test
    void listenersReceiveALatchBeforeItsRelease() {
        List<Boolean> told = new CopyOnWriteArrayList<>();
        CountDownLatch telling = new CountDownLatch(1);
        team.addListener(new TeamListener() {
            @Override
            public void latchChanged(boolean latched) {
                telling.countDown();
                if (latched) {
                    gate.pass();
                }
                told.add(latched);
            }
        });

        aside(team::stopAll);
        WaitLimit.await("the latch", telling);
        team.release();
        gate.open();

        WaitLimit.until("latch and release", () -> told.size() == 2);
        assertThat(told).containsExactly(true, false);
        assertThat(team.isLatched()).isFalse();
    }
}
