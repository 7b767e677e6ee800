package majicsim.pioneer;

import java.util.Map;
import java.util.TreeMap;

/** Reads a SIP by the sheet's offsets (8), written apart from the encoder it tests. */
public record SipView(byte[] packet) {
    public static boolean isSip(byte[] packet) {
        return (packet[3] & 0xF0) == 0x30;
    }

    public int type() {
        return packet[3];
    }

    public int x() {
        return signed(1);
    }

    public int y() {
        return signed(3);
    }

    public int heading() {
        return signed(5);
    }

    public double headingDeg() {
        return heading() * 360.0 / 4096;
    }

    public int left() {
        return signed(7);
    }

    public int right() {
        return signed(9);
    }

    public int battery() {
        return ubyte(11);
    }

    public boolean isStalled() {
        return (ubyte(12) & ubyte(13) & 1) == 1;
    }

    public int rearBumpers() {
        return ubyte(12) >> 1;
    }

    public int frontBumpers() {
        return ubyte(13) >> 1;
    }

    public int control() {
        return signed(14);
    }

    public int flags() {
        return signed(16);
    }

    public boolean hasMotors() {
        return (flags() & 1) == 1;
    }

    public Map<Integer, Integer> sonar() {
        Map<Integer, Integer> readings = new TreeMap<>();
        for (int i = 0; i < ubyte(19); i++) {
            readings.put(ubyte(20 + 3 * i), signed(21 + 3 * i));
        }
        return readings;
    }

    public int compass() {
        return ubyte(18);
    }

    public int gripper() {
        return ubyte(tail());
    }

    public int analogPort() {
        return ubyte(tail() + 1);
    }

    public int analog() {
        return ubyte(tail() + 2);
    }

    public int digitalIn() {
        return ubyte(tail() + 3);
    }

    public int digitalOut() {
        return ubyte(tail() + 4);
    }

    public int chargeState() {
        return ubyte(tail() + 7);
    }

    public int turnRateTenths() {
        return signed(tail() + 8);
    }

    int faults() {
        return signed(tail() + 10);
    }

    int celsius() {
        return (byte) ubyte(tail() + 14);
    }

    public int chargePercent() {
        return ubyte(tail() + 15);
    }

    long clockMicros() {
        return (signed(tail() + 16) & 0xFFFFL) | (signed(tail() + 18) & 0xFFFFL) << 16;
    }

    /** How many bytes stand between the sonar readings and the checksum. */
    int tailLength() {
        return packet.length - 5 - tail();
    }

    private int tail() {
        return 20 + 3 * ubyte(19);
    }

    private int ubyte(int offset) {
        return packet[offset + 3] & 0xFF;
    }

    private int signed(int offset) {
        return (short) (ubyte(offset) | ubyte(offset + 1) << 8);
    }
}
