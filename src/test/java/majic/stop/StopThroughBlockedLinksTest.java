package majic.stop;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import majic.bot.BotListener;
import majic.bot.FakeBot;
import majic.console.Console;
import majic.log.SessionListener;
import majic.program.FirstRobots;
import majic.program.Program;
import majic.program.UserFolder;
import majic.server.LineServer;
import majic.team.Gate;
import majic.team.TeamListener;
import majic.time.TimeSource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests that a STOP at the console and one at a socket reach the robots that take data while the links of others block
 * and every listener blocks, and that the blocked robots are named while their links still block.
 */
class StopThroughBlockedLinksTest {
    private static final List<Integer> BLOCKED = List.of(2, 4);
    private static final int ROBOTS = 4;

    @TempDir
    private Path folder;

    private final Gate gate = Gate.closed();
    private final List<FakeBot> bots = new ArrayList<>();
    private final BlockingQueue<String> typed = new LinkedBlockingQueue<>();
    private final BlockingQueue<String> shown = new LinkedBlockingQueue<>();
    private Program program;

    @BeforeEach
    void connect() throws IOException {
        program = new Program(new UserFolder(folder), null, false);
        for (int number = 1; number <= ROBOTS; number++) {
            FakeBot bot = FakeBot.on(TimeSource.system());
            bot.connect();
            bots.add(bot);
            program.team().add(bot, OptionalInt.of(number));
            if (BLOCKED.contains(number)) {
                bot.whenStoppedAhead(gate::pass);
            }
        }
        program.team().addListener(gate.blocked(TeamListener.class));
        program.session().addListener(gate.blocked(SessionListener.class));
        bots.forEach(bot -> bot.addListener(gate.blocked(BotListener.class)));
    }

    @AfterEach
    void close() {
        gate.open();
        program.close();
    }

    @Test
    void stopAtTheConsoleReachesTheOtherRobotsAndNamesTheBlockedOnes() throws Exception {
        Thread console = new Thread(() -> new Console(program, new Screen()).run(FirstRobots.NONE, List.of()));
        console.setDaemon(true);
        console.start();

        typed.add("stop");

        assertOnlyFreeRobotsAreHalted();
    }

    @Test
    void stopAtASocketReachesTheOtherRobotsAndNamesTheBlockedOnes() throws Exception {
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        LineServer server = program.listen(anyPort, null);
        server.ready();
        try (Socket client = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
            Thread reading = new Thread(() -> showAll(client));
            reading.setDaemon(true);
            reading.start();

            client.getOutputStream().write("stop\n".getBytes(StandardCharsets.UTF_8));

            assertOnlyFreeRobotsAreHalted();
        }
    }

    private void showAll(Socket client) {
        try (BufferedReader answers =
                new BufferedReader(new InputStreamReader(client.getInputStream(), StandardCharsets.UTF_8))) {
            answers.lines().forEach(shown::add);
        } catch (IOException | UncheckedIOException e) {
            shown.add("the connection ended");
        }
    }

    /** No blocked link is released before, so the order does not depend on time. */
    private void assertOnlyFreeRobotsAreHalted() throws InterruptedException {
        for (int number : BLOCKED) {
            awaitShown(number + ": Fake has not confirmed its stop within 0.8 s; it may still move");
        }
        for (int number = 1; number <= ROBOTS; number++) {
            boolean halted = bots.get(number - 1).sent().contains("halt");
            assertThat(halted).as("robot " + number).isNotEqualTo(BLOCKED.contains(number));
        }
    }

    private void awaitShown(String line) throws InterruptedException {
        for (String next = shown.take(); !next.equals(line); next = shown.take()) {
            assertThat(next).isNotEqualTo("the connection ended");
        }
    }

    /** Types and shows lines. */
    private final class Screen implements Console.Source {
        @Override
        public String next() {
            try {
                return typed.take();
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
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
        public void close() {
            // nothing is open
        }
    }
}
