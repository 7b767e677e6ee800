package majic.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.zip.GZIPInputStream;
import majic.mavlink.frame.MavlinkDecoder;
import majic.mavlink.frame.MavlinkEncoder;
import majic.mavlink.frame.MavlinkFrame;
import majic.mavlink.frame.MavlinkMessageType;
import majic.mavlink.frame.OutgoingMessage;
import majic.mavlink.message.LocalPosition;
import majic.mavlink.message.MavlinkRequests;
import majic.mavlink.message.ParameterValue;
import majic.mavlink.message.StatusPiece;
import majic.mavlink.message.VehicleHeartbeat;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;

/** A recorded session with ArduRover 4.6-dev, from the folder that {@code -Dmajic.captures} names. */
@EnabledIfSystemProperty(named = "majic.captures", matches = ".+")
class RecordedRoverTest {
    private final MavlinkDecoder decoder = new MavlinkDecoder();
    private final List<MavlinkFrame> frames = new ArrayList<>();
    private final List<byte[]> sent = new ArrayList<>();

    RecordedRoverTest() throws IOException {
        Path file = Path.of(System.getProperty("majic.captures"), "mavlink-rover.txt.gz");
        try (BufferedReader lines = new BufferedReader(
                new InputStreamReader(new GZIPInputStream(Files.newInputStream(file)), StandardCharsets.US_ASCII))) {
            lines.lines()
                    .filter(line -> !line.startsWith("#"))
                    .map(line -> line.strip().split("\\s+"))
                    .forEach(this::take);
        }
    }

    private void take(String... line) {
        byte[] bytes = HexFormat.of().parseHex(line[2]);
        if (line[1].equals(">")) {
            sent.add(bytes);
        } else {
            decoder.decode(bytes, bytes.length, frames::add);
        }
    }

    @Test
    void everyFrameIsReadAndNoneIsDamagedOrLost() {
        assertThat(decoder.counts().damaged()).isZero();
        assertThat(decoder.counts().lost()).isZero();
        assertThat(frames.stream().filter(frame -> frame.type() == MavlinkMessageType.ATTITUDE))
                .hasSize(930);
        assertThat(frames.stream().filter(frame -> frame.type() == MavlinkMessageType.LOCAL_POSITION_NED))
                .hasSize(875);
    }

    @Test
    void theRequestsAreByteForByteThoseOfTheRecordedGroundStation() {
        assertSent(MavlinkRequests.heartbeat());
        assertSent(MavlinkRequests.command(1, MavlinkRequests.ARM, 0, 1));
        assertSent(MavlinkRequests.command(1, MavlinkRequests.REQUEST_MESSAGE, 0, 148));
        assertSent(MavlinkRequests.interval(1, MavlinkMessageType.ATTITUDE, 10));
        assertSent(MavlinkRequests.interval(1, MavlinkMessageType.LOCAL_POSITION_NED, 10));
        assertSent(MavlinkRequests.command(1, MavlinkRequests.SET_MODE, 0, 1, 15));
        assertSent(MavlinkRequests.command(1, MavlinkRequests.SET_MODE, 0, 1, 4));
        assertSent(MavlinkRequests.readParameter(1, "WP_SPEED"));
        assertSent(MavlinkRequests.setParameter(1, "WP_SPEED", Float.floatToIntBits(2f), 9));
        assertSent(MavlinkRequests.velocity(1, 1000, -Math.toDegrees(0.3)));
        assertSent(MavlinkRequests.velocity(1, 0, 0));
        assertSent(MavlinkRequests.velocity(1, -1000, 0));
        assertSent(MavlinkRequests.velocity(1, 0, Math.toDegrees(0.5)));
    }

    /** The ground station has sent the same frame, whatever its sequence number. */
    private void assertSent(OutgoingMessage message) {
        boolean found = sent.stream().anyMatch(recorded -> {
            byte[] own = new byte[0];
            MavlinkEncoder encoder = new MavlinkEncoder();
            for (int number = 0; number <= (recorded[4] & 0xFF); number++) {
                own = encoder.encode(message, 2);
            }
            return Arrays.equals(own, recorded);
        });
        assertThat(found).as("the recorded session has " + message.type()).isTrue();
    }

    @Test
    void messagesHaveTheValuesOfTheSession() {
        assertThat(frames.stream()
                        .filter(frame -> frame.type() == MavlinkMessageType.HEARTBEAT)
                        .map(frame -> VehicleHeartbeat.of(frame.payload())))
                .allMatch(heartbeat -> heartbeat.type() == 10 && heartbeat.autopilot() == 3)
                .anyMatch(VehicleHeartbeat::armed)
                .anyMatch(heartbeat -> heartbeat.customMode() == 15);
        assertThat(frames.stream()
                        .filter(frame -> frame.type() == MavlinkMessageType.STATUSTEXT)
                        .map(frame -> StatusPiece.of(frame.payload()).text()))
                .contains("Arm: Accels inconsistent", "target not received last 3secs, stopping");
        assertThat(frames.stream()
                        .filter(frame -> frame.type() == MavlinkMessageType.PARAM_VALUE)
                        .map(frame -> ParameterValue.of(frame.payload())))
                .anyMatch(value -> value.name().equals("WP_SPEED") && value.value() == 2);
        assertThat(frames.stream()
                        .filter(frame -> frame.type() == MavlinkMessageType.LOCAL_POSITION_NED)
                        .map(frame -> LocalPosition.of(frame.payload())))
                .anyMatch(LocalPosition::isZero)
                .anyMatch(position -> position.northM() > 5);
    }
}
