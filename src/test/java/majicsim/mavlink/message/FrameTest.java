package majicsim.mavlink.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Frames as bytes, with the examples of the sheet. */
class FrameTest {
    private static final String HEARTBEAT_V1 = "fe0900ffbe000000000006080004034921";
    private static final String HEARTBEAT_V2 = "fd09000001ffbe0000000000000006080004032dc6";

    private static Message heartbeat() {
        return new Message(MessageType.HEARTBEAT)
                .with("type", 6)
                .with("autopilot", 8)
                .with("system_status", 4)
                .with("mavlink_version", 3);
    }

    @Test
    void theHeartbeatOfAGroundStationHasTheBytesOfTheSheet() {
        assertThat(hex(new Frame(1, 0, 255, 190, heartbeat()))).isEqualTo(HEARTBEAT_V1);
        assertThat(hex(new Frame(2, 1, 255, 190, heartbeat()))).isEqualTo(HEARTBEAT_V2);
    }

    @Test
    void onePayloadByteRemainsOfAMessageThatIsAllZero() {
        Frame attitude = new Frame(2, 0, 1, 1, new Message(MessageType.ATTITUDE));
        assertThat(hex(attitude)).isEqualTo("fd010000000101" + "1e0000" + "00" + "01be");
        assertThat(read(attitude.toBytes()).get(0).message().number("yaw")).isZero();
    }

    @Test
    void aVersion1FrameHasNoExtensions() {
        Message override = new Message(MessageType.RC_CHANNELS_OVERRIDE)
                .with("chan1_raw", 1500)
                .with("chan18_raw", 1700);
        assertThat(new Frame(1, 0, 255, 190, override).toBytes()).hasSize(18 + 8);
        assertThat(new Frame(2, 0, 255, 190, override).toBytes()).hasSize(38 + 12);
        assertThatThrownBy(() -> new Frame(1, 0, 1, 1, new Message(MessageType.OBSTACLE_DISTANCE)))
                .hasMessage("MAVLink 1 has no OBSTACLE_DISTANCE");
    }

    /** CRC_EXTRA is made of the names and types of the fields, so a wrong one would show here. */
    @ParameterizedTest
    @EnumSource(MessageType.class)
    void theFieldsHaveTheNamesAndTypesThatTheirChecksumSays(MessageType type) {
        Checksum checksum = new Checksum();
        add(checksum, type.name() + " ");
        for (Field field : type.fields()) {
            if (!field.isExtension()) {
                add(checksum, field.type().definitionName() + " " + field.name() + " ");
                if (field.isArray()) {
                    checksum.add(field.count());
                }
            }
        }
        assertThat((checksum.value() ^ checksum.value() >> 8) & 0xFF).isEqualTo(type.crcExtra());
    }

    private static void add(Checksum checksum, String text) {
        byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
        checksum.add(bytes, 0, bytes.length);
    }

    /** Lengths of sheet 6 to 9. */
    @ParameterizedTest
    @CsvSource({
        "HEARTBEAT,9",
        "SYS_STATUS,43",
        "GPS_RAW_INT,52",
        "ATTITUDE,28",
        "LOCAL_POSITION_NED,28",
        "GLOBAL_POSITION_INT,28",
        "VFR_HUD,20",
        "COMMAND_ACK,10",
        "POSITION_TARGET_LOCAL_NED,51",
        "DISTANCE_SENSOR,39",
        "RANGEFINDER,8",
        "OBSTACLE_DISTANCE,167",
        "BATTERY_STATUS,54",
        "EXTENDED_SYS_STATE,2",
        "STATUSTEXT,54",
        "AUTOPILOT_VERSION,78",
        "SET_POSITION_TARGET_LOCAL_NED,53",
        "COMMAND_LONG,33",
        "COMMAND_INT,35",
        "RC_CHANNELS_OVERRIDE,38"
    })
    void aMessageIsAsLongAsTheSheetSays(MessageType type, int length) {
        assertThat(type.length()).isEqualTo(length);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 64})
    void theSameFramesAreFoundHoweverTheBytesArrive(int chunk) {
        byte[] wire = HexFormat.of()
                .parseHex(text("\n\nInit Ardurover V4.6.0-dev\n") + HEARTBEAT_V1 + "00aa" + HEARTBEAT_V2
                        + HEARTBEAT_V2.replace("2dc6", "2dc7") + HEARTBEAT_V1);
        FrameReader reader = new FrameReader();
        int found = 0;
        for (int start = 0; start < wire.length; start += chunk) {
            byte[] piece = Arrays.copyOfRange(wire, start, Math.min(wire.length, start + chunk));
            for (Frame frame : reader.feed(piece)) {
                assertThat(hex(frame)).isIn(HEARTBEAT_V1, HEARTBEAT_V2);
                found++;
            }
        }
        assertThat(found).isEqualTo(3);
    }

    @Test
    void framesWithUnknownFlagsOrOfUnknownMessagesAreSkippedAndSignedOnesAreRead() {
        String unknownFlag = "fd09020001ffbe000000" + "000000000608000403" + "0000";
        String unknownMessage = "fd02000001ffbeffff00" + "fdfe" + "0000";
        String signed = signed();
        List<Frame> frames = read(HexFormat.of().parseHex(unknownFlag + unknownMessage + signed + HEARTBEAT_V2));
        assertThat(frames).hasSize(2);
    }

    private static String signed() {
        byte[] bytes = HexFormat.of().parseHex(HEARTBEAT_V2);
        bytes[2] = 1;
        int end = bytes.length - 2;
        int checksum = new Checksum().add(bytes, 1, end).add(50).value();
        bytes[end] = (byte) checksum;
        bytes[end + 1] = (byte) (checksum >> 8);
        return HexFormat.of().formatHex(bytes) + "00".repeat(13);
    }

    @Test
    void aPayloadThatIsLongerThanKnownIsReadAsFarAsItIsKnown() {
        byte[] bytes = HexFormat.of().parseHex("fd0b000001ffbe000000" + "0000000006080004030909" + "0000");
        int end = bytes.length - 2;
        int checksum = new Checksum().add(bytes, 1, end).add(50).value();
        bytes[end] = (byte) checksum;
        bytes[end + 1] = (byte) (checksum >> 8);
        assertThat(read(bytes).get(0).message().integer("mavlink_version")).isEqualTo(3);
    }

    @Test
    void aTextIsCutOrFilledToTheLengthOfItsField() {
        Message read = new Message(MessageType.PARAM_REQUEST_READ).with("param_id", "A_NAME_OF_20_LETTERS");
        assertThat(read.text("param_id")).isEqualTo("A_NAME_OF_20_LET");
        assertThat(read.with("param_id", "WP_SPEED").text("param_id")).isEqualTo("WP_SPEED");
    }

    private static List<Frame> read(byte[] bytes) {
        return new FrameReader().feed(bytes);
    }

    private static String text(String text) {
        return HexFormat.of().formatHex(text.getBytes(StandardCharsets.US_ASCII));
    }

    private static String hex(Frame frame) {
        return HexFormat.of().formatHex(frame.toBytes());
    }
}
