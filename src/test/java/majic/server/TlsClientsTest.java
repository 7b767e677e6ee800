package majic.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.CertificateFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLException;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.SSLSocketFactory;
import javax.net.ssl.TrustManagerFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests a server for other computers; its clients trust only its certificate. */
@Tag("jdk")
class TlsClientsTest {
    @TempDir
    private static Path folder;

    private static SSLSocketFactory sockets;

    private final List<TestClient> clients = new ArrayList<>();
    private RobotTeam robots;
    private LineServer server;

    @BeforeAll
    static void makeKey() throws IOException, GeneralSecurityException {
        ListenKey.create(folder);
        KeyStore trusted = KeyStore.getInstance(KeyStore.getDefaultType());
        trusted.load(null, null);
        try (InputStream pem = Files.newInputStream(folder.resolve(ListenKey.CERTIFICATE))) {
            trusted.setCertificateEntry(
                    "majic", CertificateFactory.getInstance("X.509").generateCertificate(pem));
        }
        TrustManagerFactory trust = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
        trust.init(trusted);
        SSLContext context = SSLContext.getInstance("TLS");
        context.init(null, trust.getTrustManagers(), null);
        sockets = context.getSocketFactory();
    }

    @BeforeEach
    void listen() throws IOException {
        robots = new RobotTeam();
        server = LineServer.openTls(
                new InetSocketAddress(0),
                robots.session,
                port -> ListenToken.create(folder, port),
                ListenKey.in(folder));
        server.ready();
    }

    @AfterEach
    void close() throws IOException {
        for (TestClient client : clients) {
            client.close();
        }
        server.close();
        robots.close();
    }

    private SSLSocket socket() throws IOException {
        return (SSLSocket) sockets.createSocket(InetAddress.getLoopbackAddress(), server.port());
    }

    private TestClient stranger() throws IOException {
        clients.add(new TestClient(socket()));
        return clients.get(clients.size() - 1);
    }

    private TestClient admitted() throws IOException {
        return stranger().say(server.token().orElseThrow().word());
    }

    @Test
    void aProgramSendsLinesAndGetsTheirAnswers() throws IOException {
        TestClient client = admitted().say("1 move 30", "1 get x", "close");
        assertThat(client.next()).startsWith("1 move 30: done (30 mm");
        assertThat(client.untilItIsClosed()).containsExactly("1 x = 30 mm");
    }

    @Test
    void aProgramThatEndsItsInputStillGetsTheLastAnswer() throws IOException {
        assertThat(admitted().say("1 move 30", "1 get x").all()).last().isEqualTo("1 x = 30 mm");
    }

    @Test
    void manyLinesOfAllLengthsArriveComplete() throws IOException {
        List<String> wrong = new ArrayList<>();
        for (int length = 1; length <= 150; length++) {
            wrong.add("rubbish" + "x".repeat(length * 20));
        }
        List<String> answers = admitted().say(String.join("\n", wrong), "close").untilItIsClosed();
        assertThat(answers).hasSize(wrong.size()).allMatch(answer -> answer.contains("rubbish"));
    }

    @Test
    void withoutTheTokenNothingIsObeyed() throws IOException {
        TestClient client = stranger().say("1 move 30", "stop");
        assertThat(client.untilItIsClosed()).first().asString().startsWith("the first line must be the token");
        assertThat(robots.bot.sent()).doesNotContain("move 30");
        assertThat(robots.team.isLatched()).isFalse();
    }

    @Test
    void aProgramWithoutTlsGetsTheReasonInPlainText() throws IOException {
        TestClient plain = TestClient.admitted(server);
        clients.add(plain);
        assertThat(plain.next()).startsWith("this port is for programs that use TLS");
        assertThat(plain.untilItIsClosed()).isSubsetOf("reset");
    }

    @ParameterizedTest
    @ValueSource(strings = {"session", "log", "team"})
    void aProgramOnAnotherComputerReplacesNoFile(String what) throws IOException {
        Path mine = Files.writeString(folder.resolve("mine"), "kept");
        assertThat(admitted().say("save " + what + " " + mine).next())
                .isEqualTo("save: not from another computer; type it at MAJIC's own");
        assertThat(mine).hasContent("kept");
    }

    @Test
    void aConnectionWithoutAHandshakeEnds() throws IOException {
        AtomicLong nanos = new AtomicLong();
        InetSocketAddress any = new InetSocketAddress(0);
        try (LineServer hasty = LineServer.open(
                        any,
                        robots.session,
                        port -> ListenToken.create(folder, port),
                        ListenKey.in(folder),
                        () -> nanos.addAndGet(1_000_000_000));
                TestClient silent = TestClient.of(hasty)) {
            assertThat(silent.untilItIsClosed()).as("at most an alert of TLS").hasSizeLessThan(2);
        }
    }

    @Test
    void anOlderTlsIsRefused() throws IOException {
        SSLSocket old = socket();
        old.setEnabledProtocols(new String[] {"TLSv1.2"});
        try (old) {
            assertThatThrownBy(old::startHandshake).isInstanceOf(SSLException.class);
        }
        assertThat(admitted().say("1 get x").next()).isEqualTo("1 x = 0 mm");
    }

    @Test
    void aStopOvertakesTheLinesOfAFlood() throws IOException {
        TestClient client = admitted()
                .say("1 drive 100 0 for 60s")
                .sayRaw("1 get x\n".repeat(5000))
                .say("1 stop");
        assertThat(client.await("lines not run: stopped")).isNotNull();
        assertThat(client.await("1 drive 100 0 for 60s")).endsWith(": stopped");
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has access lists in place of POSIX permissions")
    void onlyItsUserCanReadTheKey() throws IOException {
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(folder.resolve(ListenKey.FILE))))
                .isEqualTo("rw-------");
    }

    @Test
    void aKeyThatExistsIsNotReplaced() {
        assertThatThrownBy(() -> ListenKey.create(folder))
                .isInstanceOf(IOException.class)
                .hasMessageEndingWith("exists, and other computers may trust it; delete it to make a new key");
    }

    @Test
    void withoutAKeyTheReasonNamesTheCommandThatMakesOne(@TempDir Path empty) {
        assertThatThrownBy(() -> ListenKey.in(empty))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("\"majic key\" makes");
    }

    @Test
    void aDamagedKeyIsReportedInOneSentence(@TempDir Path damaged) throws IOException {
        Files.writeString(damaged.resolve(ListenKey.FILE), "rubbish");
        assertThatThrownBy(() -> ListenKey.in(damaged))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("is not a key store with MAJIC's password");
    }
}
