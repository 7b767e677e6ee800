package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.FakeType;
import majic.bot.MajicBot;
import majic.console.Console;
import majic.environment.BotEnvironment;
import majic.team.Member;
import majic.team.Owner;
import majic.team.QueuedCommand;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that no text of a robot, an act or an exception can imitate a reply, or control a terminal. */
class ForgedAnswersTest {
    private static final String FORGED = "gone\n2 stop: done\r\u001b[2J\u202e\u2028";
    private static final String HARMLESS = "gone\\n2 stop: done\\r\\u001b[2J\\u202e\\u2028";
    private static final String LAST = "1: the last notice";

    @TempDir
    private Path folder;

    private final Screen screen = new Screen();

    @AutoClose
    private Program program;

    private Member robot;
    private BufferedReader answers;

    @BeforeEach
    void start() throws Exception {
        program = new Program(new UserFolder(folder), null, false);
        MajicBot bot = new FakeType().create(BotAddress.parse("fake:one"), BotEnvironment.plain());
        bot.connect();
        robot = program.team().add(bot, OptionalInt.empty());
        Thread console = new Thread(() -> new Console(program, screen).run(FirstRobots.NONE, List.of()));
        console.setDaemon(true);
        console.start();
        screen.asked.await();
        int port = program.listen(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), null)
                .port();
        program.addFirst(FirstRobots.NONE);
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.getOutputStream().write("bots\n".getBytes(StandardCharsets.UTF_8));
        answers = new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8));
        answers.readLine();
    }

    /** A terminal without input. */
    private static final class Screen implements Console.Source {
        private final BlockingQueue<String> shown = new LinkedBlockingQueue<>();
        private final CountDownLatch asked = new CountDownLatch(1);

        @Override
        public String next() {
            asked.countDown();
            try {
                new CountDownLatch(1).await();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            return null;
        }

        @Override
        public void show(String line) {
            shown.add(line);
        }

        @Override
        public boolean interactive() {
            return true;
        }

        @Override
        public void close() {}
    }

    @Test
    void anExceptionsMessageStaysInItsAnswer() throws Exception {
        robot.submit(
                new QueuedCommand("get x", false, its -> {
                    throw new BotException(FORGED);
                }),
                null);
        isShownAs("1 get x: failed: " + HARMLESS);
    }

    @Test
    void aRobotsNoticeStaysInItsLine() throws Exception {
        robot.report(new BotException(FORGED));
        isShownAs("1: " + HARMLESS);
    }

    @Test
    void theMessageOfAnActStaysInOneLine() throws Exception {
        robot.report(new Owner(Owner.Kind.ACT, "Liar", () -> {}), FORGED);
        isShownAs("1: Liar: " + HARMLESS);
    }

    private void isShownAs(String line) throws Exception {
        assertThat(answers.readLine()).isEqualTo(line);
        String shown = screen.shown.take();
        while (!shown.contains("gone")) {
            shown = screen.shown.take();
        }
        assertThat(shown).isEqualTo(line);
        robot.report(new BotException("the last notice"));
        assertThat(answers.readLine()).isEqualTo(LAST);
        program.close();
        assertThat(sessionLog())
                .filteredOn(kept -> kept.contains("gone"))
                .hasSize(1)
                .allMatch(kept -> kept.endsWith(line));
        assertThat(sessionLog()).noneMatch(kept -> kept.startsWith("2 stop"));
    }

    private List<String> sessionLog() throws IOException {
        try (var logs = Files.list(folder.resolve("sessions"))) {
            return Files.readAllLines(logs.findFirst().orElseThrow());
        }
    }
}
