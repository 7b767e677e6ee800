package majic.docs;

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
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import majic.act.NoActs;
import majic.bot.FakeType;
import majic.bot.MajicBot;
import majic.environment.Settings;
import majic.log.SessionLog;
import majic.script.Session;
import majic.server.LineServer;
import majic.server.ListenKey;
import majic.server.ListenToken;
import majic.team.BotFactory;
import majic.team.Team;
import majic.time.TimeSource;
import majic.tool.Tool;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the clients on the page about commands from other programs. */
class ClientProgramsTest {
    private static final Path EXAMPLES = Path.of("examples");

    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"client.py", "client.m", "tls_client.py", "tls_client.m"})
    void thePageShowsTheClientAsItIs(String client) throws IOException {
        assertThat(Page.of("docs/other-programs.md").text()).contains(Files.readString(EXAMPLES.resolve(client)));
    }

    @Test
    void theClientInPythonMovesARobotAndGetsItsAnswers() throws Exception {
        Tool.require("python3");
        try (Team team = new Team(TimeSource.system());
                LineServer server = withARobot(team)) {
            String client = EXAMPLES.resolve("client.py").toString();
            String port = String.valueOf(server.port());
            String token = server.token().orElseThrow().file().toString();
            assertThat(Tool.run("python3", client, port, token, "1 move 30", "1 get x"))
                    .containsSubsequence("1 move 30: done (30 mm", "1 x = 30 mm");
        }
    }

    @Test
    void theClientInPythonOnAnotherComputerMovesARobotAndGetsItsAnswers() throws Exception {
        Tool.require("python3");
        ListenKey.create(folder);
        InetSocketAddress all = new InetSocketAddress(0);
        try (Team team = new Team(TimeSource.system());
                LineServer server = LineServer.openTls(all, withARobotIn(team), this::token, ListenKey.in(folder))) {
            server.ready();
            String client = EXAMPLES.resolve("tls_client.py").toString();
            String port = String.valueOf(server.port());
            String token = server.token().orElseThrow().file().toString();
            String certificate = folder.resolve(ListenKey.CERTIFICATE).toString();
            assertThat(Tool.run("python3", client, "127.0.0.1", port, certificate, token, "1 move 30", "1 get x"))
                    .containsSubsequence("1 move 30: done (30 mm", "1 x = 30 mm");
        }
    }

    @Test
    void theClientInPythonOnAnotherComputerReportsAnotherCertificateInOneLine(@TempDir Path other) throws Exception {
        Tool.require("python3");
        ListenKey.create(folder);
        ListenKey.create(other);
        InetSocketAddress all = new InetSocketAddress(0);
        try (Team team = new Team(TimeSource.system());
                LineServer server = LineServer.openTls(all, withARobotIn(team), this::token, ListenKey.in(folder))) {
            server.ready();
            Process client = new ProcessBuilder(
                            "python3",
                            EXAMPLES.resolve("tls_client.py").toString(),
                            "127.0.0.1",
                            String.valueOf(server.port()),
                            other.resolve(ListenKey.CERTIFICATE).toString(),
                            server.token().orElseThrow().file().toString(),
                            "1 move 30")
                    .redirectErrorStream(true)
                    .start();
            String printed = new String(client.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertThat(printed.lines())
                    .singleElement()
                    .asString()
                    .contains("certificate", "must be the newest listen.pem");
            assertThat(client.waitFor()).isEqualTo(1);
        }
    }

    /** The client in MATLAB is not run. It sends what the one in Python sends. */
    @Test
    void theLastLineOfTheClientInMatlabOnAnotherComputerEndsTheConnection() throws IOException {
        assertThat(Files.readString(EXAMPLES.resolve("tls_client.m")))
                .contains("{strtrim(fileread(tokenFile))}, varargin, {'close', ''}");
    }

    /** The client in MATLAB is not run. It keeps the connection open and waits for the answer to its last line. */
    @Test
    void theLastLineOfTheClientInMatlabIsAnsweredAfterAllOthers() throws Exception {
        assertThat(Files.readString(EXAMPLES.resolve("client.m"))).contains("{'wait', 'help quit'}", "'help: quit'");
        try (Team team = new Team(TimeSource.system());
                LineServer server = withARobot(team);
                Socket client = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
            String token = Files.readString(server.token().orElseThrow().file()).strip();
            String lines = String.join("\n", token, "1 move 30", "1 get x", "wait", "help quit", "");
            client.getOutputStream().write(lines.getBytes(StandardCharsets.UTF_8));
            BufferedReader answers =
                    new BufferedReader(new InputStreamReader(client.getInputStream(), StandardCharsets.UTF_8));
            List<String> received = new ArrayList<>();
            do {
                received.add(answers.readLine());
            } while (!received.get(received.size() - 1).startsWith("help: quit"));
            assertThat(String.join("\n", received))
                    .containsSubsequence("1 move 30: done (30 mm", "1 x = 30 mm", "help: quit");
        }
    }

    private LineServer withARobot(Team team) throws IOException {
        InetSocketAddress any = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        LineServer server = LineServer.open(any, withARobotIn(team), this::token);
        server.ready();
        return server;
    }

    private ListenToken token(int port) throws IOException {
        return ListenToken.create(folder, port);
    }

    private static Session withARobotIn(Team team) {
        BotFactory factory = new BotFactory(List.of(new FakeType()), Settings.inMemory());
        MajicBot bot = factory.create("fake://one");
        bot.connect();
        team.add(bot, OptionalInt.empty());
        return new Session(team, factory, SessionLog.none(), NoActs.here(), () -> {});
    }
}
