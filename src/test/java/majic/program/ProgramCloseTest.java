package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.OptionalInt;
import java.util.concurrent.CountDownLatch;
import majic.bot.BotListener;
import majic.bot.FakeBot;
import majic.bot.MajicBot;
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
        Thread first = start(program);
        closing.await();

        Thread second = start(program);
        second.join(300);
        assertThat(second.isAlive()).isTrue();

        mayClose.countDown();
        second.join();
        first.join();
    }

    private static Thread start(Program program) {
        Thread thread = new Thread(program::close);
        thread.start();
        return thread;
    }

    private Program programWithASlowRobot(Path folder) throws IOException {
        Program program = new Program(new UserFolder(folder), null, false);
        FakeBot robot = FakeBot.on(TimeSource.system());
        robot.connect();
        program.team().add(robot, OptionalInt.empty());
        robot.addListener(new BotListener() {
            @Override
            public void connectionChanged(MajicBot bot, MajicBot.Connection now) {
                closing.countDown();
                await(mayClose);
            }
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
