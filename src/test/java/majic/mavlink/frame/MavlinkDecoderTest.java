package majic.mavlink.frame;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Frames found in bytes; the examples are of the protocol sheet and of a recorded rover. */
class MavlinkDecoderTest {
    private static final byte[] HEARTBEAT_1 = hex("fe0900ffbe00000000000608000403" + "4921");
    private static final byte[] HEARTBEAT_2 = hex("fd09000001ffbe000000000000000608000403" + "2dc6");
    private static final byte[] ZERO_ATTITUDE = hex("fd01000000" + "01011e0000" + "00" + "01be");
    private static final byte[] OF_ROVER = hex("fd090000020101000000100000000a03410203a4ec");
    private static final byte[] TEXT = "\n\nInit ArduRover V4.6.0-dev".getBytes(StandardCharsets.US_ASCII);

    private final MavlinkDecoder decoder = new MavlinkDecoder();
    private final List<MavlinkFrame> frames = new ArrayList<>();

    private static byte[] hex(String digits) {
        return HexFormat.of().parseHex(digits);
    }

    private void decode(byte[]... parts) {
        for (byte[] part : parts) {
            decoder.decode(part, part.length, frames::add);
        }
    }

    private static byte[] concat(byte[]... parts) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (byte[] part : parts) {
            all.writeBytes(part);
        }
        return all.toByteArray();
    }

    @Test
    void framesOfBothVersionsAreRead() {
        decode(HEARTBEAT_1, HEARTBEAT_2);

        assertThat(frames).extracting(MavlinkFrame::version).containsExactly(1, 2);
        assertThat(frames).allSatisfy(frame -> {
            assertThat(frame.type()).isEqualTo(MavlinkMessageType.HEARTBEAT);
            assertThat(frame.system()).isEqualTo(255);
            assertThat(frame.component()).isEqualTo(190);
            assertThat(frame.payload().u8(4)).isEqualTo(6);
        });
    }

    @Test
    void zerosThatWereLeftOutAreThereAgain() {
        decode(ZERO_ATTITUDE);

        assertThat(frames).hasSize(1);
        assertThat(frames.get(0).payload().f32(24)).isZero();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 64})
    void theSameFramesAreFoundHoweverTheBytesArrive(int chunk) {
        byte[] damaged = OF_ROVER.clone();
        damaged[12] ^= 1;
        byte[] wire = concat(TEXT, OF_ROVER, damaged, HEARTBEAT_1, ZERO_ATTITUDE);

        for (int start = 0; start < wire.length; start += chunk) {
            decode(Arrays.copyOfRange(wire, start, Math.min(wire.length, start + chunk)));
        }

        assertThat(frames)
                .extracting(MavlinkFrame::type)
                .containsExactly(
                        MavlinkMessageType.HEARTBEAT, MavlinkMessageType.HEARTBEAT, MavlinkMessageType.ATTITUDE);
        assertThat(decoder.counts().damaged()).isEqualTo(1);
    }

    @Test
    void aGoodFrameInsideADamagedOneIsNotLost() {
        byte[] outer = concat(hex("fd1500000001010000" + "00"), OF_ROVER, hex("0000"));

        decode(outer);

        assertThat(frames).hasSize(1);
        assertThat(decoder.counts().damaged()).isEqualTo(1);
    }

    @Test
    void missingSequenceNumbersAreCountedAsLost() {
        decode(MavlinkEncoder.encode(new OutgoingMessage(MavlinkMessageType.ATTITUDE), 2, 254));
        decode(MavlinkEncoder.encode(new OutgoingMessage(MavlinkMessageType.ATTITUDE), 2, 2));

        assertThat(decoder.counts()).isEqualTo(new FrameCounts(2, 3, 0, 0));
    }

    private void decodeNumbers(int... numbers) {
        for (int number : numbers) {
            decode(MavlinkEncoder.encode(new OutgoingMessage(MavlinkMessageType.ATTITUDE), 2, number));
        }
    }

    @Test
    void aRepeatedFrameIsNotALoss() {
        decodeNumbers(7, 7, 8, 8, 9);

        assertThat(decoder.counts()).isEqualTo(new FrameCounts(5, 0, 0, 0));
    }

    @Test
    void aFrameThatOthersHaveOvertakenIsLostOnlyUntilItArrives() {
        decodeNumbers(254, 1);
        assertThat(decoder.counts().lost()).isEqualTo(2);

        decodeNumbers(255, 0, 2, 0, 255);

        assertThat(decoder.counts().lost()).isZero();
    }

    @Test
    void aFrameOfBeforeTheFirstOneIsNeitherLostNorFound() {
        decodeNumbers(10, 9, 11, 13);

        assertThat(decoder.counts().lost()).isEqualTo(1);
    }

    @Test
    void aSenderThatCountsAnewHasLostNothing() {
        decodeNumbers(100, 0, 1, 3);

        assertThat(decoder.counts().lost()).isEqualTo(1);
    }

    @Test
    void anUnknownMessageIsSkippedAndCountsAsArrived() {
        decode(HEARTBEAT_2, hex("fd02000002ffbe0f2700" + "fefd" + "1234"));
        decode(MavlinkEncoder.encode(new OutgoingMessage(MavlinkMessageType.ATTITUDE), 2, 3));

        assertThat(frames).hasSize(2);
        assertThat(decoder.counts()).isEqualTo(new FrameCounts(3, 0, 0, 0));
    }

    @Test
    void aSignedFrameIsReadAndOneWithUnknownFlagsIsNot() {
        byte[] signed = MavlinkEncoder.encode(new OutgoingMessage(MavlinkMessageType.ATTITUDE), 2, 0);
        signed[2] = 1;
        int end = signed.length - 2;
        int crc = X25.of(signed, 1, end, 39);
        signed[end] = (byte) crc;
        signed[end + 1] = (byte) (crc >> 8);
        byte[] flagged = HEARTBEAT_2.clone();
        flagged[2] = 2;

        decode(concat(signed, new byte[13]), flagged, OF_ROVER);

        assertThat(frames)
                .extracting(MavlinkFrame::type)
                .containsExactly(MavlinkMessageType.ATTITUDE, MavlinkMessageType.HEARTBEAT);
        assertThat(frames.get(1).system()).isEqualTo(1);
    }

    @Test
    void bytesBeyondTheKnownLengthAreIgnored() {
        byte[] frame = hex("fd0c00000001010000" + "00" + "100000000a03410203" + "010203" + "0000");
        int crc = X25.of(frame, 1, frame.length - 2, 50);
        frame[frame.length - 2] = (byte) crc;
        frame[frame.length - 1] = (byte) (crc >> 8);

        decode(frame);

        assertThat(frames).hasSize(1);
        assertThat(frames.get(0).payload().u32(0)).isEqualTo(16);
    }
}
