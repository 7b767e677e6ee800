package majic.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import majic.act.NoActs;
import majic.bot.FakeBot;
import majic.bot.FakeType;
import majic.environment.Settings;
import majic.log.SessionLog;
import majic.script.Session;
import majic.team.BotFactory;
import majic.team.Team;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Tag("jdk")
class LineServerTest {
    private static final InetSocketAddress ANY_PORT = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);

    @TempDir
    private Path folder;

    private final Team team = new Team(TimeSource.system());
    private final BotFactory factory = new BotFactory(List.of(new FakeType()), Settings.inMemory());
    private final Session session = new Session(team, factory, SessionLog.none(), NoActs.here(), () -> {});
    private final List<TestClient> clients = new ArrayList<>();
    private FakeBot bot;
    private LineServer server;

    @BeforeEach
    void listen() throws IOException {
        server = LineServer.open(ANY_PORT, session, port -> ListenToken.create(folder, port));
        server.ready();
        bot = (FakeBot) factory.create("fake://one");
        bot.connect();
        team.add(bot, OptionalInt.empty());
    }

    @AfterEach
    void close() throws IOException {
        for (TestClient client : clients) {
            client.close();
        }
        server.close();
        team.close();
    }

    private TestClient client() throws IOException {
        return kept(TestClient.admitted(server));
    }

    private TestClient client(LineServer to) throws IOException {
        return kept(TestClient.of(to));
    }

    private TestClient kept(TestClient client) {
        clients.add(client);
        return client;
    }

    private String token() {
        return server.token().orElseThrow().word();
    }

    @Test
    void aProgramSendsALineAndGetsItsAnswer() throws IOException {
        assertThat(client().say("1 move 30").await("1 move 30")).startsWith("1 move 30: done (30 mm");
    }

    @Test
    void aWrongLineIsAnsweredAndTheNextOneStillWorks() throws IOException {
        TestClient client = client().say("\u0000\u0007 rubbish");
        assertThat(client.next()).isNotBlank();
        assertThat(client.say("bots").next()).startsWith("1: ");
    }

    @Test
    void aClientThatEndsItsInputStillGetsTheLastAnswer() throws IOException {
        assertThat(client().say("1 move 30", "1 get x").all()).last().isEqualTo("1 x = 30 mm");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "wrong", "POST / HTTP/1.1", "1 move 30"})
    void withoutTheTokenNothingIsObeyed(String first) throws IOException {
        TestClient client = client(server).say(first, "1 move 30", "stop");
        assertThat(client.untilItIsClosed().get(0)).startsWith("the first line must be the token");
        assertThat(bot.sent()).doesNotContain("move 30");
        assertThat(team.isLatched()).isFalse();
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has access lists in place of POSIX permissions")
    void theTokenIsInAFileThatOnlyItsUserCanRead() throws IOException {
        Path file = server.token().orElseThrow().file();
        assertThat(Files.readString(file).strip()).isEqualTo(token());
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
                .isEqualTo("rw-------");
        server.close();
        assertThat(file).doesNotExist();
    }

    @ParameterizedTest
    @ValueSource(strings = {"POST / HTTP/1.1", "GET / HTTP/1.1", "Host: 127.0.0.1:7777", "\u0016\u0003\u0001"})
    void openToAllItStillObeysNoWebPage(String first) throws IOException {
        try (LineServer open = LineServer.open(ANY_PORT, session, null)) {
            open.ready();
            TestClient page = client(open).say(first, "Content-Type: text/plain", "", "1 move 30");
            assertThat(page.untilItIsClosed().get(0)).startsWith("the first line must be MAJIC Script");
            assertThat(bot.sent()).doesNotContain("move 30");
            assertThat(client(open).say("1 move 30").await("1 move 30")).contains("done");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"trust Some.act", "trust Some.act 12345678", "trust off Some.act"})
    void trustIsForTheWindowAndTheTerminal(String line) throws IOException {
        assertThat(client().say(line).next())
                .isEqualTo("trust: not over a socket; type it in the window or at the" + " terminal of MAJIC");
    }

    @Test
    void aLastLineWithoutLineEndIsNotObeyed() throws IOException {
        assertThat(client().sayRaw("1 turn 90\n1 move 30").all())
                .contains("the last line has no line end and was not obeyed: 1 move 30");
        assertThat(bot.sent()).doesNotContain("move 30");
    }

    @Test
    void aStopIsObeyedEvenWithoutLineEnd() throws IOException {
        client().sayRaw("stop").all();
        assertThat(team.isLatched()).isTrue();
    }

    @Test
    void answersGoToTheSendingClientAndToThoseThatRequestedAll() throws IOException {
        TestClient other = client();
        TestClient all = client(server).say(token() + " all");
        other.say("1 get x");
        other.next();
        all.say("1 get y");
        all.await("1 y = ");
        TestClient asking = client();
        asking.say("1 move 30").await("1 move 30: done");
        asking.say("rubbish").await("rubbish");
        assertThat(all.next()).startsWith("1 move 30: done");
        assertThat(all.next()).startsWith("rubbish");
        other.say("1 get heading");
        assertThat(other.next()).startsWith("1 heading");
    }

    @Test
    void linesThatConcernAllAreSentToAll() throws IOException {
        TestClient other = client().say("bots");
        other.next();
        client().say("stop");
        assertThat(other.await("STOP is latched")).isNotNull();
    }

    @Test
    void linesWaitForTheRobotsOfTheCommandLineButStopsDoNot() throws IOException {
        try (LineServer early = LineServer.open(ANY_PORT, session, null)) {
            TestClient client = client(early).say("bots", "stop");
            assertThat(client.next()).isEqualTo("1 line not run: stopped");
            client.await("STOP is latched");
            client.say("2 get x");
            FakeBot second = (FakeBot) factory.create("fake://two");
            second.connect();
            team.add(second, OptionalInt.empty());
            early.ready();
            assertThat(client.await("2 x")).isEqualTo("2 x = 0 mm");
        }
    }

    @Test
    void idleClientsCostNoThreads() throws IOException {
        client().say("bots").next();
        int before = Thread.activeCount();
        for (int count = 1; count < ClientPlaces.MOST_CLIENTS; count++) {
            client().say("bots").next();
        }
        assertThat(Thread.activeCount()).isLessThan(before + 5);
    }

    @Test
    void oneClientTooManyIsRefusedAndTheNextOneTakesAFreePlace() throws IOException {
        for (int count = 0; count < ClientPlaces.MOST_CLIENTS; count++) {
            client().say("bots").next();
        }
        assertThat(client().untilItIsClosed().get(0))
                .isEqualTo("MAJIC has 64 clients already, which is the most; close one of them");
        clients.get(0).close();
        String answer = "MAJIC has";
        while (answer == null || answer.startsWith("MAJIC has")) {
            answer = askAnew();
        }
        assertThat(answer).startsWith("1: ");
    }

    private String askAnew() {
        try {
            return client().say("bots").next();
        } catch (IOException e) {
            return null;
        }
    }

    @Test
    void aFloodOfConnectionsAndOfLinesHoldsUpNoStop() throws Exception {
        TestClient stopper = driving();
        int threadsBefore = Thread.activeCount();
        Thread connecting = new Thread(this::connectAndLeave);
        connecting.start();
        TestClient flooding = client();
        Thread lines = new Thread(() -> flood(flooding));
        lines.start();
        stopper.say("1 stop");
        assertThat(stopper.await("1 drive 100 0 for 60s")).endsWith(": stopped");
        connecting.join();
        int threads = Thread.activeCount();
        stopper.say("stop");
        assertThat(stopper.await("STOP is latched")).isNotNull();
        assertThat(threads).isLessThan(threadsBefore + 15);
        flooding.close();
        lines.join();
    }

    /** Returns a client whose drive is in progress: until then, its stop would discard the drive. */
    private TestClient driving() throws IOException {
        TestClient client = client().say("1 drive 100 0 for 60s");
        WaitLimit.until("the drive", () -> bot.sent().contains("drive 100 0"));
        return client;
    }

    private void connectAndLeave() {
        try {
            for (int count = 0; count < 500; count++) {
                new Socket(InetAddress.getLoopbackAddress(), server.port()).close();
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void flood(TestClient client) {
        String many = "1 help\n".repeat(1000);
        try {
            while (true) {
                client.sayRaw(many);
            }
        } catch (IOException e) {
            // It was dropped, as it should be.
        }
    }

    @Test
    void aClientsStopGoesPastItsOwnFlood() throws IOException {
        TestClient client = driving().sayRaw("1 get x\n".repeat(5000)).say("1 stop");
        assertThat(client.await("lines not run: stopped")).isNotNull();
        assertThat(client.await("1 drive 100 0 for 60s")).endsWith(": stopped");
    }

    @Test
    void theLineCloseEndsTheConnectionAfterTheLastAnswer() throws IOException {
        assertThat(client().say("1 move 30", "1 get x", "close", "1 move 50").untilItIsClosed())
                .last()
                .isEqualTo("1 x = 30 mm");
        assertThat(bot.sent()).doesNotContain("move 50");
    }

    @Test
    void controlCharactersOfALineReachNoClient() throws IOException {
        assertThat(client().sayRaw("1 move 30\u001b[2J").all())
                .contains("the last line has no line end and was not obeyed: 1 move 30\\u001b[2J");
    }

    @Test
    void aLineOfTheLongestCharactersIsRefusedAsAWhole() throws IOException {
        assertThat(client().say("1 move 30" + "\u2003".repeat(4000)).next())
                .isEqualTo("the line is longer than 4000 characters");
        assertThat(bot.sent()).doesNotContain("move 30");
    }

    @Test
    void withoutTlsOnlyThisComputerMayCommandTheRobots() {
        assertThatThrownBy(() -> LineServer.open(new InetSocketAddress("0.0.0.0", 0), session, null))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("127.0.0.1");
    }
}
