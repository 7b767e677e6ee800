package majicsim.pioneer;

import java.util.ArrayList;
import java.util.List;

/** Reads a laser packet by the sheet's layout (11.8), written apart from the encoder it tests. */
public record LaserView(byte[] packet) {
    public static boolean isLaser(byte[] packet) {
        return packet[3] == 0x60 || packet[3] == 0x61;
    }

    public int type() {
        return packet[3];
    }

    public List<Integer> pose() {
        return List.of((int) (short) uint(4), (int) (short) uint(6), (int) (short) uint(8));
    }

    public int total() {
        return uint(head());
    }

    public int first() {
        return uint(head() + 2);
    }

    public List<Integer> ranges() {
        List<Integer> ranges = new ArrayList<>();
        int size = type() == 0x61 ? 5 : 2;
        for (int i = 0; i < (packet[head() + 4] & 0xFF); i++) {
            ranges.add(uint(head() + 5 + i * size));
        }
        return ranges;
    }

    public int flags() {
        return packet[packet.length - 3] & 0xFF;
    }

    private int head() {
        return type() == 0x60 ? 10 : 4;
    }

    private int uint(int offset) {
        return packet[offset] & 0xFF | (packet[offset + 1] & 0xFF) << 8;
    }
}
