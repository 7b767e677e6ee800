package majicsim.pioneer.packet;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PacketReaderTest {
    private static final byte[] ENABLE = Hex.bytes("FA FB 06 04 3B 01 00 05 3B");
    private static final byte[] VEL = Hex.bytes("FA FB 06 0B 3B FA 00 05 3B");
    private static final byte[] WRONG_CHECKSUM = Hex.bytes("FA FB 06 0B 3B FA 00 05 3C");
    private static final byte[] RADIO_NOISE = Hex.bytes("57 4D 53 32 0D");

    private final PacketReader reader = new PacketReader();

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 64})
    void findsTheSamePacketsHoweverTheBytesArrive(int chunk) {
        byte[] wire = Hex.concat(RADIO_NOISE, ENABLE, WRONG_CHECKSUM, VEL, Hex.bytes("FA"), ENABLE);
        assertThat(inChunks(wire, chunk)).containsExactly("4:3b0100", "11:3bfa00", "4:3b0100");
        assertThat(reader.skippedBytes()).isEqualTo(RADIO_NOISE.length + WRONG_CHECKSUM.length + 1);
    }

    @Test
    void headerBytesInsideTheDataAreData() {
        byte[] place =
                new PacketWriter(224).uint8(0x3B).int32(-1030).int32(0).int32(0).toBytes();
        assertThat(inChunks(place, 5)).containsExactly("224:3bfafbffff0000000000000000");
    }

    @Test
    void aGoodPacketInsideADamagedOneIsFound() {
        byte[] damagedCount = Hex.bytes("FA FB 0C 0B 3B");
        byte[] wire = Hex.concat(damagedCount, ENABLE, ENABLE);
        assertThat(inChunks(wire, 4)).containsExactly("4:3b0100", "4:3b0100");
    }

    @ParameterizedTest
    @ValueSource(strings = {"FA FB 00", "FA FB 01 05", "FA FB 02 00 00"})
    void aCountTooSmallIsNoise(String noise) {
        assertThat(inChunks(Hex.concat(Hex.bytes(noise), VEL), 1)).containsExactly("11:3bfa00");
    }

    @Test
    void theLongestPacketIsTaken() {
        PacketWriter longest = new PacketWriter(15);
        for (int i = 0; i < 252; i++) {
            longest.uint8(i);
        }
        assertThat(inChunks(longest.toBytes(), 64)).hasSize(1);
    }

    @Test
    void packetsBehindAFragmentAreFoundWhenTheFragmentIsDiscarded() {
        assertThat(reader.feed(Hex.concat(Hex.bytes("FA FB C8 04"), VEL))).isEmpty();
        assertThat(reader.hasFragment()).isTrue();
        assertThat(reader.giveUpFragment()).extracting(Packet::id).containsExactly(11);
        assertThat(reader.hasFragment()).isFalse();
    }

    private List<String> inChunks(byte[] wire, int size) {
        List<String> found = new ArrayList<>();
        for (int at = 0; at < wire.length; at += size) {
            byte[] chunk = Arrays.copyOfRange(wire, at, Math.min(wire.length, at + size));
            reader.feed(chunk)
                    .forEach(packet ->
                            found.add(packet.id() + ":" + HexFormat.of().formatHex(packet.data())));
        }
        return found;
    }
}
