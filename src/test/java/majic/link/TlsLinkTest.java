package majic.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLException;
import javax.net.ssl.TrustManagerFactory;
import majic.bot.ConnectFailed;
import majic.ros.MajicRos;
import majic.time.WaitLimit;
import majic.tool.KeyTool;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** Links over TLS to a server that sends back what it receives. */
@Isolated("replaces the trust store of this Java")
class TlsLinkTest {
    private static final char[] PASSWORD = "for the test".toCharArray();

    @TempDir
    private static Path folder;

    private static KeyStore keys;

    private final SSLContext before = defaultContext();

    @AutoClose
    private ServerSocket server;

    private static SSLContext defaultContext() {
        try {
            return SSLContext.getDefault();
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException(e);
        }
    }

    @BeforeAll
    static void makeAKey() throws Exception {
        keys = KeyTool.make(
                folder.resolve("keys.p12"), new String(PASSWORD), "robot", "CN=robot", "-ext", "san=ip:127.0.0.1");
    }

    private static SSLContext context() throws GeneralSecurityException, IOException {
        KeyManagerFactory own = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm());
        own.init(keys, PASSWORD);
        KeyStore trusted = KeyStore.getInstance(KeyStore.getDefaultType());
        trusted.load(null, null);
        trusted.setCertificateEntry("robot", keys.getCertificate("robot"));
        TrustManagerFactory trust = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
        trust.init(trusted);
        SSLContext context = SSLContext.getInstance("TLS");
        context.init(own.getKeyManagers(), trust.getTrustManagers(), null);
        return context;
    }

    @BeforeEach
    void listen() throws Exception {
        server = context().getServerSocketFactory().createServerSocket(0, 5, InetAddress.getLoopbackAddress());
        serve(server);
    }

    /** Accepts connections on a thread of its own, until the server is closed. */
    private static void serve(ServerSocket listening) {
        Thread thread = new Thread(() -> {
            while (!listening.isClosed()) {
                try (Socket client = listening.accept()) {
                    client.getInputStream().transferTo(client.getOutputStream());
                } catch (IOException e) {
                    // The client has gone, or the test is over.
                }
            }
        });
        thread.setDaemon(true);
        thread.start();
    }

    @AfterEach
    void restoreTheTrustStore() {
        SSLContext.setDefault(before);
    }

    @Test
    void bytesGoBothWaysAndAreCounted() throws Exception {
        SSLContext.setDefault(context());
        try (Link link = Links.secure("127.0.0.1", server.getLocalPort())) {
            link.open(WaitLimit.MS);
            link.write("hello".getBytes(StandardCharsets.US_ASCII));
            byte[] buffer = new byte[100];
            int count = link.read(buffer);

            assertThat(new String(buffer, 0, count, StandardCharsets.US_ASCII)).isEqualTo("hello");
            assertThat(link.traffic().written()).isEqualTo(5);
            assertThat(link.traffic().remote()).isEqualTo("127.0.0.1:" + server.getLocalPort());
        }
    }

    @Test
    void aCertificateThatIsNotTrustedIsRefused() {
        Link link = Links.secure("127.0.0.1", server.getLocalPort());

        assertThatThrownBy(() -> link.open(WaitLimit.MS)).isInstanceOf(SSLException.class);
        assertThat(link.traffic().open()).isFalse();
    }

    @Test
    void aCertificateForAnotherHostIsRefused() throws Exception {
        SSLContext.setDefault(context());

        assertThatThrownBy(
                        () -> Links.secure("localhost", server.getLocalPort()).open(WaitLimit.MS))
                .isInstanceOf(SSLException.class)
                .hasMessageContaining("localhost");
    }

    @Test
    void aRobotWithAnUntrustedCertificateIsExplained() {
        try (MajicRos robot = new MajicRos("ross://127.0.0.1:" + server.getLocalPort())) {
            assertThatThrownBy(robot::connect)
                    .isInstanceOf(ConnectFailed.class)
                    .hasMessageContaining(
                            "the certificate of 127.0.0.1 port " + server.getLocalPort() + " is not trusted")
                    .hasMessageContaining("keytool -importcert -cacerts -alias 127.0.0.1 -file ")
                    .hasMessageNotContaining("ros://");
        }
    }

    @Test
    void aServerThatRefusesTheHandshakeIsNotTakenForOneWithoutTls() throws IOException {
        byte[] handshakeFailure = {0x15, 3, 3, 0, 2, 2, 40};
        try (ServerSocket refusing = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
                MajicRos robot = new MajicRos("ross://127.0.0.1:" + refusing.getLocalPort())) {
            Thread server = new Thread(() -> {
                try (Socket client = refusing.accept()) {
                    client.getInputStream().read(new byte[10_000]);
                    client.getOutputStream().write(handshakeFailure);
                    client.getInputStream().read(new byte[10_000]);
                } catch (IOException e) {
                    // The test has ended.
                }
            });
            server.setDaemon(true);
            server.start();

            assertThatThrownBy(robot::connect)
                    .isInstanceOf(ConnectFailed.class)
                    .hasMessageContaining("TLS failed")
                    .hasMessageNotContaining("ros://");
        }
    }

    @Test
    void aServerThatSendsNothingIsGivenUp() throws IOException {
        try (ServerSocket mute = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
            assertThatThrownBy(
                            () -> Links.secure("127.0.0.1", mute.getLocalPort()).open(50))
                    .isInstanceOf(SocketTimeoutException.class)
                    .hasMessage(
                            "127.0.0.1 port " + mute.getLocalPort() + " was reached, but began no TLS within 0.05 s");
        }
    }

    @Test
    void aServerWithoutTlsIsExplained() throws IOException {
        try (ServerSocket plain = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
                MajicRos robot = new MajicRos("ross://127.0.0.1:" + plain.getLocalPort())) {
            serve(plain);

            assertThatThrownBy(robot::connect)
                    .isInstanceOf(ConnectFailed.class)
                    .hasMessageContaining("TLS failed")
                    .hasMessageContaining("ros://127.0.0.1:" + plain.getLocalPort());
        }
    }
}
