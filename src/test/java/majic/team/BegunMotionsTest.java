package majic.team;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import majic.bot.FakeBot;
import majic.bot.Guard;
import majic.bot.MotionOrder;
import majic.bot.MotionStopped;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Motions of a robot that queues its commands: the thread that submits one begins it, and the worker finishes it. */
class BegunMotionsTest {
    private static final String HERE = Thread.currentThread().getName();

    @AutoClose
    private final TeamFixture fixture = new TeamFixture();

    private final FakeBot bot = fixture.join();

    @BeforeEach
    void listen() {
        fixture.listen();
        bot.queueCommands();
    }

    @Test
    void aMotionIsSentByTheThreadThatSubmitsIt() throws InterruptedException {
        submit(move(100));

        assertThat(ahead()).containsExactly("Move[mm=100.0] ahead by " + HERE);
        assertThat(fixture.awaitIdle(1)).isTrue();
        assertThat(fixture.said).singleElement().asString().startsWith("1 move 100: done (100 mm");
    }

    @Test
    void aMotionBehindAnotherOneIsLeftToTheWorker() throws InterruptedException {
        submit(move(100));
        submit(move(200));

        assertThat(fixture.awaitIdle(1)).isTrue();
        assertThat(ahead()).containsExactly("Move[mm=100.0] ahead by " + HERE);
        assertThat(bot.sent()).containsSubsequence("move 100", "move 200");
    }

    @Test
    void aMotionThatMayBeHeldIsLeftToTheWorker() throws InterruptedException {
        submit(move(100).heldUntil(() -> {}));

        assertThat(fixture.awaitIdle(1)).isTrue();
        assertThat(ahead()).isEmpty();
        assertThat(bot.sent()).contains("move 100");
    }

    @Test
    void aBegunMotionThatIsStoppedEndsAsStoppedAndTheNextOneRuns() throws InterruptedException {
        submit(move(1000));
        fixture.team.stop(fixture.team.members(), null);
        assertThat(fixture.awaitIdle(1)).isTrue();
        submit(move(100));
        assertThat(fixture.awaitIdle(1)).isTrue();

        assertThat(fixture.said).contains("1 move 1000: stopped");
        assertThat(fixture.said).last().asString().startsWith("1 move 100: done");
        assertThat(ahead()).hasSize(2);
    }

    @Test
    void aMotionOutsideOfTheLimitsIsSentByNoThread() throws InterruptedException {
        submit(QueuedCommand.motion("turn", new MotionOrder.Turn(1e9), Guard.NEVER, report -> List.of("turn: done")));

        assertThat(fixture.awaitIdle(1)).isTrue();
        assertThat(bot.sent()).noneMatch(sent -> sent.startsWith("turn") || sent.startsWith("Turn"));
        assertThat(fixture.said).singleElement().asString().startsWith("1 turn: failed: turn 1000000000: not an angle");
    }

    @Test
    void aCheckThatRefusesTheMotionIsReportedOnce() throws InterruptedException {
        submit(move(100).checkedBy(() -> {
            throw new MotionStopped("stopped");
        }));

        assertThat(fixture.awaitIdle(1)).isTrue();
        assertThat(bot.sent()).noneMatch(sent -> sent.startsWith("move") || sent.startsWith("Move"));
        assertThat(fixture.said).containsExactly("1 move 100: not run: stopped");
    }

    @Test
    void aHandDriveIsSentByTheThreadThatAsksForIt() {
        try (ManualControl control = new ManualControl(fixture.team.member(1))) {
            control.drive(100, 0);

            assertThat(bot.sent()).contains("drive 100 0");
        }
    }

    private void submit(QueuedCommand command) {
        fixture.team.member(1).submit(command, null);
    }

    private static QueuedCommand move(double mm) {
        String text = "move " + (int) mm;
        return QueuedCommand.motion(
                text, new MotionOrder.Move(mm), Guard.NEVER, report -> List.of(text + ": done (" + report + ")"));
    }

    private List<String> ahead() {
        return bot.sent().stream().filter(sent -> sent.contains(" ahead by ")).toList();
    }
}
