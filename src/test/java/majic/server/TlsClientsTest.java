package majic.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.cert.CertificateFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import javax.net.ssl.SSLException;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.SSLSocketFactory;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests a server for other computers; its clients trust only its certificate. */
@Tag("jdk")
class TlsClientsTest {
    @TempDir
    private static Path folder;

    private static SSLSocketFactory sockets;

    @AutoClose
    private ServedClients clients;

    @BeforeAll
    static void makeKey() throws IOException, GeneralSecurityException {
        ListenKey.create(folder);
        try (InputStream pem = Files.newInputStream(folder.resolve(ListenKey.CERTIFICATE))) {
            sockets = TrustedSockets.of(CertificateFactory.getInstance("X.509").generateCertificate(pem));
        }
    }

    @BeforeEach
    void listen() throws IOException {
        ListenKey key = ListenKey.in(folder);
        clients = new ServedClients(
                sockets,
                robots -> LineServer.openTls(
                        new InetSocketAddress(0), robots.session, port -> ListenToken.create(folder, port), key));
    }

    private SSLSocket socket() throws IOException {
        return (SSLSocket) clients.socket();
    }

    private TestClient stranger() throws IOException {
        return clients.stranger();
    }

    private TestClient admitted() throws IOException {
        return clients.admitted();
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
        assertThat(clients.robots.bot.sent()).doesNotContain("move 30");
        assertThat(clients.robots.team.isLatched()).isFalse();
    }

    @Test
    void aProgramWithoutTlsGetsTheReasonInPlainText() throws IOException {
        try (TestClient plain = TestClient.admitted(clients.server)) {
            assertThat(plain.next()).startsWith("this port is for programs that use TLS");
            assertThat(plain.untilItIsClosed()).isSubsetOf("reset");
        }
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
                        clients.robots.session,
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
}
