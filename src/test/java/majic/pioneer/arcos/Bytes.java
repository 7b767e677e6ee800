package majic.pioneer.arcos;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;

/** Bytes in the notation of the protocol sheet, and packets captured from the maker's programs. */
public final class Bytes {
    /** ARCOS sheet A4. */
    public static final String NAMES =
            "FA FB 18 02 41 4D 52 49 53 69 6D 00 50 69 6F 6E 65 65 72 00 70 33 64 78 00 EB BD";

    /** ARCOS sheet A5. */
    public static final String CONFIG = """
            FA FB 79 20 50 69 6F 6E 65 65 72 00 70 33 64 78 00 53 49 4D 00 00
            0F 27 0F 27 0F 27 0F 27 90 01 41 4D 52 49 53 69 6D 00 64 00 00
            00 00 01 00 01 00 00 00 00 D0 07 00 00 00 00 00 00 00 00 00
            96 00 B8 0B 64 00 64 00 00 00 00 00 00 00 2C 01 2C 01 00 00 00 00 00 00
            00 00 00 00 02 00 00 00 00 00 00 00 00 00 53 2E 30 00 00 00 00 00 00
            0F 27 0F 27 00 00 00 00 00 00 00 00 93 5F""";

    /** ARCOS sheet A6: at rest. */
    public static final String AT_REST = """
            FA FB 56 32 00 00 00 00 00 00 00 00 00 00 82 00 00 00 00 1F 00 00 10
            00 18 0F 01 88 13 02 5F 11 03 88 13 04 88 13 05 88 13 06 88 13 07 04 0F
            08 04 0F 09 CD 0A 0A DD 07 0B D7 06 0C D8 06 0D DD 07 0E CC 0A 0F 18 0F
            00 00 00 FF FF 82 00 00 00 00 00 00 00 00 81 00 B0 CD""";

    /** ARCOS sheet A7: ahead and turning right. */
    public static final String TURNING_RIGHT = """
            FA FB 56 32 07 02 95 FF 12 FF 28 01 CB 00 82 00 00 00 00 1F 00 00 10
            00 78 10 01 27 10 02 88 13 03 88 13 04 88 13 05 41 13 06 A7 0F 07 C0 0F
            08 15 10 09 FB 08 0A DB 07 0B E2 07 0C 14 09 0D 85 0C 0E 08 10 0F 23 10
            00 00 00 FF FF 82 00 00 6A FF 00 00 00 00 81 00 26 9E""";

    /** ARCOS sheet A9: stalled. */
    public static final String STALLED = """
            FA FB 56 32 5E 02 74 FF 06 FF 00 00 00 00 82 01 01 00 00 1F 00 00 10
            00 18 0F 01 DE 00 02 7E 00 03 64 00 04 64 00 05 7E 00 06 DF 00 07 04 0F
            08 04 0F 09 88 13 0A 88 13 0B 88 13 0C 88 13 0D 04 0F 0E 88 13 0F 18 0F
            00 00 00 FF FF 82 00 00 00 00 00 00 00 00 81 00 57 F4""";

    private Bytes() {}

    public static byte[] of(String hex) {
        return HexFormat.of().parseHex(hex.replaceAll("\\s", ""));
    }

    public static String hex(byte[] bytes) {
        return HexFormat.ofDelimiter(" ").withUpperCase().formatHex(bytes);
    }

    public static byte[] joined(String... parts) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (String part : parts) {
            all.writeBytes(of(part));
        }
        return all.toByteArray();
    }

    /** The packets in some bytes that arrive in one piece. */
    public static List<Packet> packets(String... parts) {
        List<Packet> packets = new ArrayList<>();
        byte[] all = joined(parts);
        new FrameDecoder().feed(all, all.length, packets::add);
        return packets;
    }

    public static Packet packet(String hex) {
        return packets(hex).get(0);
    }

    /** A packet built without the driver's encoder. */
    public static byte[] wire(int type, byte[] data) {
        byte[] packet = new byte[data.length + 6];
        packet[0] = (byte) 0xFA;
        packet[1] = (byte) 0xFB;
        packet[2] = (byte) (data.length + 3);
        packet[3] = (byte) type;
        System.arraycopy(data, 0, packet, 4, data.length);
        int sum = 0;
        for (int at = 3; at < data.length + 4; at++) {
            boolean high = (at - 3) % 2 == 0;
            boolean single = high && at == data.length + 3;
            int value = packet[at] & 0xFF;
            sum = single ? sum ^ value : sum + (high ? value << 8 : value) & 0xFFFF;
        }
        packet[data.length + 4] = (byte) (sum >> 8);
        packet[data.length + 5] = (byte) sum;
        return packet;
    }

    public static Sip sip(String hex) {
        Sip sip = Sip.decode(packet(hex));
        if (sip == null) {
            throw new AssertionError("not a SIP: " + hex);
        }
        return sip;
    }
}
