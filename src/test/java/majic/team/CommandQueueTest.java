package majic.team;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import majic.bot.FakeBot;
import majic.bot.MotionStopped;
import majic.driver.Permit;
import majic.driver.PermittedControl;
import majic.drivertest.TestClock;
import org.junit.jupiter.api.Test;

/** The queue of one source of commands. */
class CommandQueueTest {
    @Test
    void aCommandDoesNotBeginAfterAStopThatCameWhileTheWorkerWoke() throws InterruptedException {
        try (TestClock clock = new TestClock()) {
            AtomicInteger checks = new AtomicInteger();
            TeamEvents events = new TeamEvents(clock.time(), clock.time().signal());
            CommandQueue queue =
                    new CommandQueue(1, clock.time(), events, new Object(), () -> checks.incrementAndGet() == 1);
            QueuedCommand command = new QueuedCommand("move 100", true, robot -> List.of());
            command.accept(new PermittedControl(FakeBot.on(clock.time()), new Permit()));
            queue.add(command);
            queue.start("worker");
            clock.time().sleep(1);
            queue.close();

            assertThat(checks).hasValueGreaterThan(1);
            assertThat(command.outcome()).isNull();
        }
    }

    @Test
    void eachCommandIsReportedBeforeItHasAnEffect() throws InterruptedException {
        List<String> events = new CopyOnWriteArrayList<>();
        run((robot, command) -> events.add(robot + " " + command), events);

        assertThat(events).containsExactly("1 move 100", "moved", "1 move 100", "moved");
    }

    @Test
    void aListenerThatFailsKeepsNoCommandFromBeingRun() throws InterruptedException {
        List<String> events = new CopyOnWriteArrayList<>();
        run(
                (robot, command) -> {
                    throw new IllegalStateException("a listener that fails");
                },
                events);

        assertThat(events).containsExactly("moved", "moved");
    }

    @Test
    void anAcceptedCommandTakesNoFurtherCheck() {
        try (TestClock clock = new TestClock()) {
            QueuedCommand command = new QueuedCommand("move 100", true, robot -> List.of());
            command.accept(new PermittedControl(FakeBot.on(clock.time()), new Permit()));

            assertThatThrownBy(() -> command.checkedBy(() -> {}))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessage("move 100 was submitted before");
        }
    }

    /** Runs two equal commands and one that must not begin. */
    private static void run(CommandListener listener, List<String> events) throws InterruptedException {
        try (TestClock clock = new TestClock()) {
            TeamEvents team = new TeamEvents(clock.time(), clock.time().signal());
            team.commandListeners().add(listener);
            CommandQueue queue = new CommandQueue(1, clock.time(), team, new Object(), () -> true);
            QueuedCommand.Work work = robot -> {
                events.add("moved");
                return List.of();
            };
            QueuedCommand refused = new QueuedCommand("turn 90", true, work).checkedBy(() -> {
                throw new MotionStopped("stopped");
            });
            for (QueuedCommand command : List.of(
                    new QueuedCommand("move 100", true, work), new QueuedCommand("move 100", true, work), refused)) {
                command.accept(new PermittedControl(FakeBot.on(clock.time()), new Permit()));
                queue.add(command);
            }
            queue.start("worker");
            clock.time().sleep(1);
            queue.close();
        }
    }
}
