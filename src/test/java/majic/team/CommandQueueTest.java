package majic.team;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import majic.TestClock;
import majic.bot.FakeBot;
import majic.bot.Permit;
import majic.bot.PermittedControl;
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
}
