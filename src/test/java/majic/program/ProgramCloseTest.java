package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.OptionalInt;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import majic.bot.FakeBot;
import majic.time.TimeSource;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the end of the program when it is requested twice at once: Ctrl-C while "quit" is being carried out. */
@Tag("jdk")
class ProgramCloseTest {
    private final CountDownLatch closing = new CountDownLatch(1);
    private final CountDownLatch mayClose = new CountDownLatch(1);

    @Test
    void whoeverClosesSecondWaitsForTheRobotsToo(@TempDir Path folder) throws Exception {
        Program program = programWithASlowRobot(folder);
        Thread first = start(program::close);
        closing.await();

        AtomicBoolean wasEarly = new AtomicBoolean();
        Thread second = start(() -> {
            program.close();
            wasEarly.set(mayClose.getCount() > 0);
        });
        while (second.getState() != Thread.State.TIMED_WAITING && second.isAlive()) {
            Thread.onSpinWait();
        }

        mayClose.countDown();
        second.join();
        first.join();
        assertThat(wasEarly).isFalse();
    }

    private static Thread start(Runnable task) {
        Thread thread = new Thread(task);
        thread.start();
        return thread;
    }

    private Program programWithASlowRobot(Path folder) throws IOException {
        Program program = new Program(new UserFolder(folder), null, false);
        FakeBot robot = FakeBot.on(TimeSource.system());
        robot.connect();
        program.team().add(robot, OptionalInt.empty());
        robot.whenStoppedAhead(() -> {
            closing.countDown();
            await(mayClose);
        });
        return program;
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
