package majic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import majic.act.NoActs;
import majic.bot.FakeType;
import majic.bot.MajicBot;
import majic.bot.Settings;
import majic.log.SessionLog;
import majic.script.Session;
import majic.server.LineServer;
import majic.server.ListenToken;
import majic.team.BotFactory;
import majic.team.Team;
import majic.time.TimeSource;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the example client of the user's guide. */
class PythonClientTest {
    private static final Path CLIENT = Path.of("examples", "client.py");

    @Test
    void theGuideShowsTheClientAsItIs() throws IOException {
        assertThat(Files.readString(Path.of("docs", "user-guide.md"))).contains(Files.readString(CLIENT));
    }

    @Test
    void theClientMovesARobotAndGetsItsAnswers(@TempDir Path folder) throws Exception {
        assumeTrue(hasPython());
        try (Team team = new Team(TimeSource.system())) {
            BotFactory factory = new BotFactory(List.of(new FakeType()), Settings.inMemory());
            MajicBot bot = factory.create("fake://one");
            bot.connect();
            team.add(bot, OptionalInt.empty());
            Session session = new Session(team, factory, SessionLog.none(), NoActs.here(), () -> {});
            InetSocketAddress any = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
            try (LineServer server = LineServer.open(any, session, port -> ListenToken.create(folder, port))) {
                server.ready();
                String port = String.valueOf(server.port());
                String token = server.token().orElseThrow().file().toString();
                assertThat(python(CLIENT.toString(), port, token, "1 move 30", "1 get x"))
                        .containsSubsequence("1 move 30: done (30 mm", "1 x = 30 mm");
            }
        }
    }

    static boolean hasPython() {
        try {
            return python("--version").startsWith("Python 3");
        } catch (IOException | InterruptedException e) {
            return false;
        }
    }

    static String python(String... arguments) throws IOException, InterruptedException {
        ProcessBuilder command = new ProcessBuilder("python3").redirectErrorStream(true);
        command.command().addAll(List.of(arguments));
        Process process = command.start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        process.waitFor();
        return said;
    }
}
