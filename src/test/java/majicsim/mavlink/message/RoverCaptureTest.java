package majicsim.mavlink.message;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;

/** A session of ArduRover 4.6 with a ground station, from the folder that {@code -Dmajic.captures} names. */
@EnabledIfSystemProperty(named = "majic.captures", matches = ".+")
class RoverCaptureTest {
    private static final int MAGIC = 0xFD;

    @Test
    void everyFrameIsReadAndWrittenAgainAsItWas() throws IOException {
        for (String direction : List.of("<", ">")) {
            List<byte[]> lines = lines(direction);
            List<String> sent = lines.stream()
                    .filter(line -> (line[0] & 0xFF) == MAGIC)
                    .map(HexFormat.of()::formatHex)
                    .toList();
            FrameReader reader = new FrameReader();
            List<String> read = reader.feed(joined(lines)).stream()
                    .map(frame -> HexFormat.of().formatHex(frame.toBytes()))
                    .toList();

            assertThat(read).hasSizeGreaterThan(200).isEqualTo(sent);
            assertThat(reader.damaged()).isZero();
        }
    }

    @Test
    void theValuesAreThoseOfTheSession() throws IOException {
        List<Frame> frames = new FrameReader().feed(joined(lines("<")));

        assertThat(frames.stream()
                        .map(Frame::message)
                        .filter(message -> message.type() == MessageType.STATUSTEXT)
                        .map(message -> message.text("text")))
                .contains(
                        "ArduPilot Ready",
                        "Arm: Accels inconsistent",
                        "EKF3 IMU0 is using GPS",
                        "target not received last 3secs, stopping");
        assertThat(frames.stream()
                        .map(Frame::message)
                        .filter(message -> message.type() == MessageType.PARAM_VALUE)
                        .filter(message -> message.text("param_id").equals("WP_SPEED"))
                        .map(message -> message.number("param_value")))
                .containsExactly(3.0, 2.0);
        assertThat(frames).allSatisfy(frame -> assertThat(frame.system()).isEqualTo(1));
    }

    private static byte[] joined(List<byte[]> pieces) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        pieces.forEach(all::writeBytes);
        return all.toByteArray();
    }

    private static List<byte[]> lines(String direction) throws IOException {
        Path file = Path.of(System.getProperty("majic.captures"), "mavlink-rover.txt.gz");
        try (BufferedReader text = new BufferedReader(
                new InputStreamReader(new GZIPInputStream(Files.newInputStream(file)), StandardCharsets.US_ASCII))) {
            List<byte[]> lines = new ArrayList<>();
            for (String line = text.readLine(); line != null; line = text.readLine()) {
                String[] words = line.strip().split(" ");
                if (!line.startsWith("#") && words[1].equals(direction)) {
                    lines.add(HexFormat.of().parseHex(words[2]));
                }
            }
            return lines;
        }
    }
}
