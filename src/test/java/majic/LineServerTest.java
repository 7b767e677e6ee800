package majic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import majic.act.NoActs;
import majic.bot.BotFactory;
import majic.bot.FakeType;
import majic.bot.Settings;
import majic.bot.Team;
import majic.bot.TimeSource;
import majic.log.SessionLog;
import majic.script.Session;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(30)
class LineServerTest {
    private final Team team = new Team(TimeSource.system());
    private final Session session = new Session(
            team,
            new BotFactory(List.of(new FakeType()), Settings.inMemory()),
            SessionLog.none(),
            NoActs.here(),
            () -> {});
    private LineServer server;

    @BeforeEach
    void listen() throws IOException {
        server = LineServer.open(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), session);
    }

    @AfterEach
    void close() {
        server.close();
        team.close();
    }

    private static void say(Socket socket, String line) throws IOException {
        socket.getOutputStream().write((line + "\n").getBytes(StandardCharsets.UTF_8));
    }

    private static BufferedReader answers(Socket socket) throws IOException {
        return new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8));
    }

    private static String awaitLine(BufferedReader answers, String part) throws IOException {
        String line = answers.readLine();
        while (line != null && !line.contains(part)) {
            line = answers.readLine();
        }
        return line;
    }

    @Test
    void aProgramSaysALineAndGetsItsAnswer() throws IOException {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
            BufferedReader answers = answers(socket);
            say(socket, "add fake://here");
            say(socket, "1 move 30");

            assertThat(awaitLine(answers, "1 move 30")).startsWith("1 move 30: done (30 mm");
        }
    }

    @Test
    void aWrongLineIsAnsweredAndTheNextOneStillWorks() throws IOException {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
            BufferedReader answers = answers(socket);
            say(socket, "\u0000\u0007 rubbish");
            assertThat(answers.readLine()).isNotBlank();
            say(socket, "bots");

            assertThat(awaitLine(answers, "no robots")).isNotNull();
        }
    }

    @Test
    void aProgramThatHangsUpLeavesNoThreadBehind() throws Exception {
        Set<Thread> before = writers();
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
            say(socket, "bots");
            awaitLine(answers(socket), "no robots");
        }

        Set<Thread> after = writers();
        after.removeAll(before);
        for (Thread writer : after) {
            writer.join(5000);
        }

        assertThat(after).noneMatch(Thread::isAlive);
    }

    private static Set<Thread> writers() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().equals("client writer"))
                .collect(Collectors.toCollection(HashSet::new));
    }

    @Test
    void whoEndsItsInputStillHearsTheLastAnswer() throws IOException {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
            say(socket, "add fake://here");
            say(socket, "1 move 30");
            say(socket, "1 get x");
            socket.shutdownOutput();

            assertThat(answers(socket).lines().toList()).last().isEqualTo("1 x = 30 mm");
        }
    }

    @Test
    void onlyThisMachineMayCommandTheRobots() {
        assertThatThrownBy(() -> LineServer.open(new InetSocketAddress("0.0.0.0", 0), session))
                .isInstanceOf(UsageException.class)
                .hasMessageContaining("127.0.0.1");
    }
}
