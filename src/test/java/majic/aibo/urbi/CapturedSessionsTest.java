package majic.aibo.urbi;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The full captured sessions, where they are at hand. */
@EnabledIfSystemProperty(named = "majic.captures", matches = ".+")
class CapturedSessionsTest {
    private static final String RECEIVED = "< ";

    static Stream<Path> sessions() throws IOException {
        Path folder = Path.of(System.getProperty("majic.captures"), "urbi");
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(CapturedSessionsTest::isTranscript).sorted().toList().stream();
        }
    }

    private static boolean isTranscript(Path file) {
        return read(file).stream().anyMatch(line -> line.startsWith(RECEIVED));
    }

    @ParameterizedTest
    @MethodSource("sessions")
    void everyLineOfASessionIsOneMessageInOnePieceAndByteByByte(Path session) {
        List<String> lines = read(session).stream()
                .filter(line -> line.startsWith(RECEIVED))
                .map(line -> line.substring(RECEIVED.length()))
                .toList();
        byte[] wire = lines.stream().collect(Collectors.joining("\n", "", "\n")).getBytes(StandardCharsets.ISO_8859_1);

        List<UrbiMessage> whole = new UrbiDecoder().feed(wire, wire.length);

        UrbiDecoder slow = new UrbiDecoder();
        List<UrbiMessage> byteByByte = Stream.iterate(0, at -> at < wire.length, at -> at + 1)
                .flatMap(at -> slow.feed(new byte[] {wire[at]}, 1).stream())
                .toList();
        assertThat(whole).hasSameSizeAs(lines).isEqualTo(byteByByte);
        assertThat(whole).noneMatch(message -> message.body() instanceof UrbiMessage.Continued);
        assertThat(whole).noneMatch(CapturedSessionsTest::isUnread);
    }

    private static boolean isUnread(UrbiMessage message) {
        return message.body() instanceof UrbiMessage.Result result && result.value() instanceof UrbiValue.Other;
    }

    private static List<String> read(Path file) {
        try {
            return Files.readAllLines(file, StandardCharsets.ISO_8859_1);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
