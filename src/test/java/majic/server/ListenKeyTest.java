package majic.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import majic.text.OneSentence;
import majic.tool.KeyTool;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests the key of the server for other computers, and what is said when it is missing, damaged or too old. */
@Tag("jdk")
class ListenKeyTest {
    @TempDir
    private Path folder;

    /** Makes a key with the file and the password of MAJIC's. */
    private ListenKey key(String start, int days) throws Exception {
        Path file = folder.resolve(ListenKey.FILE);
        KeyTool.make(
                file, ListenKey.PASSWORD, "majic", "CN=MAJIC", "-startdate", start, "-validity", String.valueOf(days));
        return ListenKey.unchecked(file);
    }

    @Test
    void anExpiredKeyIsRefusedAtTheStartInOneSentence() throws Exception {
        key("-20d", 10);
        assertThatThrownBy(() -> ListenKey.in(folder))
                .isInstanceOf(IOException.class)
                .satisfies(problem -> OneSentence.check(problem.getMessage()))
                .hasMessage(folder.resolve(ListenKey.FILE)
                        + ": its certificate has expired; delete the file, and \"majic key\" makes a new one");
    }

    @Test
    void aKeyFromTheFutureIsRefusedBecauseOfTheClock() throws Exception {
        key("+20d", 10);
        assertThatThrownBy(() -> ListenKey.in(folder)).hasMessageContaining("is not valid yet; set the clock");
    }

    @Test
    void aKeyIsWarnedOfThirtyDaysBeforeItExpires() throws Exception {
        ListenKey key = key("-1d", 41);
        Instant end = key.certificate().getNotAfter().toInstant();
        assertThat(key.warning(end.minus(Duration.ofDays(31)))).isEmpty();
        String soon = key.warning(end.minus(Duration.ofDays(29))).orElseThrow();
        OneSentence.check(soon);
        assertThat(soon).startsWith("the certificate of --listen expires on ");
        assertThat(key.warning(end.plusSeconds(1)).orElseThrow()).contains("expired on ", "\"majic key\"");
    }

    @Test
    void aServerWhoseCertificateExpiresWhileItRunsReportsItOnceAndToEachProgram() throws Exception {
        ListenKey expired = key("-20d", 10);
        List<String> messages = new ArrayList<>();
        try (RobotTeam robots = new RobotTeam();
                LineServer server = LineServer.openTls(
                        new InetSocketAddress(0), robots.session, port -> ListenToken.create(folder, port), expired)) {
            robots.session.addListener(line -> messages.add(line.text()));
            server.ready();
            var sockets = TrustedSockets.of(expired.certificate());
            for (int program = 0; program < 2; program++) {
                var socket = sockets.createSocket(InetAddress.getLoopbackAddress(), server.port());
                try (TestClient client = new TestClient(socket)) {
                    client.say(server.token().orElseThrow().word(), "1 get x");
                    assertThat(client.next()).startsWith("the certificate of --listen expired on ");
                    assertThat(client.await("1 x")).isEqualTo("1 x = 0 mm");
                }
            }
        }
        assertThat(messages.stream().filter(text -> text.contains("expired"))).hasSize(1);
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has access lists in place of POSIX permissions")
    void onlyItsUserCanReadTheKey() throws IOException {
        ListenKey.create(folder);
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(folder.resolve(ListenKey.FILE))))
                .isEqualTo("rw-------");
    }

    @Test
    void aKeyThatExistsIsNotReplaced() throws IOException {
        ListenKey.create(folder);
        assertThatThrownBy(() -> ListenKey.create(folder))
                .isInstanceOf(IOException.class)
                .hasMessageEndingWith("exists, and other computers may trust it; delete it to make a new key");
    }

    @Test
    void withoutAKeyTheReasonNamesTheCommandThatMakesOne() {
        assertThatThrownBy(() -> ListenKey.in(folder))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("\"majic key\" makes");
    }

    @Test
    void aDamagedKeyIsReportedInOneSentence() throws IOException {
        Files.writeString(folder.resolve(ListenKey.FILE), "rubbish");
        assertThatThrownBy(() -> ListenKey.in(folder))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("is not a key store with MAJIC's password");
    }
}
