package majic.server;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.api.BugDetectors;
import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.regex.Pattern;
import javax.net.SocketFactory;
import majic.text.VisibleText;
import org.junit.jupiter.api.io.TempDir;

/**
 * Arbitrary bytes of clients: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see CONTRIBUTING.md).
 */
class ListenFuzzTest {
    private static final InetSocketAddress ANY_PORT = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);

    /** What would read or write files of any name, or take longer than the test. */
    private static final Pattern FILES_AND_TIME = Pattern.compile(
            "save|run|act|trust|log|wait|repeat|while|until|for|probe",
            Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CASE);

    private static final String LOCAL = ANY_PORT.getHostName();
    private static final long NANOS_PER_LOOK = 10_000_000;
    private static final int LONGEST_LINE = 16_100;

    @TempDir
    private Path folder;

    private final AtomicLong nanos = new AtomicLong();

    /** Time passes while lines may be held at their rate; it stands while a client has to send its token in time. */
    private volatile long nanosPerLook;

    @FuzzTest
    void anyLinesOfAClientAreAnsweredInLinesAndAnotherStopsItsRobot(byte[] lines) throws IOException {
        try (ServedClients clients = clients()) {
            byte[] sent = tamed(lines);
            TestClient client = clients.admitted().say("bots");
            client.next();
            nanosPerLook = NANOS_PER_LOOK;
            List<String> answers = client.sayBytes(sent).sayRaw("\n").all();
            nanosPerLook = 0;
            assertThat(answers).allMatch(answer -> answer.equals(VisibleText.of(answer)));
            isServed(clients);
        }
    }

    @FuzzTest
    void anyFirstLinesButTheTokenAreRefusedInOneLine(byte[] lines) throws IOException {
        try (ServedClients clients = clients()) {
            List<String> answers =
                    clients.stranger().sayBytes(lines).sayRaw("\n").all();
            assertThat(answers).hasSize(1).allMatch(answer -> answer.equals(VisibleText.of(answer)));
            assertThat(clients.robots.bot.sent()).isEmpty();
            isServed(clients);
        }
    }

    @FuzzTest
    void theSameLinesComeHoweverTheBytesAreCut(byte[] bytes) {
        int chunk = bytes.length == 0 ? 1 : 1 + (bytes[0] & 0x3F);

        List<String> whole = decode(bytes, Math.max(1, bytes.length));

        assertThat(decode(bytes, chunk)).isEqualTo(whole);
        assertThat(whole).allMatch(line -> line.length() <= LONGEST_LINE && !line.contains("\n"));
    }

    private static List<String> decode(byte[] bytes, int chunk) {
        LineDecoder decoder = new LineDecoder();
        List<String> lines = new ArrayList<>();
        for (int at = 0; at < bytes.length; at += chunk) {
            byte[] part = Arrays.copyOfRange(bytes, at, Math.min(bytes.length, at + chunk));
            lines.addAll(decoder.feed(ByteBuffer.wrap(part)));
        }
        lines.add(decoder.rest());
        return lines;
    }

    /** The lines before may have removed the robot. */
    private static void isServed(ServedClients clients) throws IOException {
        List<String> answers = clients.admitted().say("stop", "bots").all();
        assertThat(answers).isNotEmpty();
        if (!clients.robots.team.members().isEmpty()) {
            assertThat(answers).anyMatch(answer -> answer.endsWith(" stop: done"));
        }
        assertThat(clients.robots.bot.sent()).contains("halt");
    }

    /** The bytes as they are, or as text if they contain what has to be left out. */
    private static byte[] tamed(byte[] lines) {
        String text = new String(lines, StandardCharsets.UTF_8).replace("\r", "");
        return FILES_AND_TIME.matcher(text).find()
                ? FILES_AND_TIME.matcher(text).replaceAll("get").getBytes(StandardCharsets.UTF_8)
                : lines;
    }

    private ServedClients clients() throws IOException {
        BugDetectors.allowNetworkConnections((host, port) -> host.equals(LOCAL));
        return new ServedClients(
                SocketFactory.getDefault(),
                robots -> LineServer.open(
                        ANY_PORT,
                        robots.session,
                        port -> ListenToken.create(folder, port),
                        null,
                        () -> nanos.addAndGet(nanosPerLook)));
    }
}
