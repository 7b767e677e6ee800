package majic.pioneer.arcos;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/** Builds the data of a SIP (ARCOS sheet 8). */
public final class SipBytes {
    private final ByteBuffer data = ByteBuffer.allocate(200).order(ByteOrder.LITTLE_ENDIAN);
    private int readings;

    public SipBytes() {
        data.put(10, (byte) 125);
        data.position(19);
    }

    public SipBytes pose(int x, int y, int heading) {
        data.putShort(0, (short) x).putShort(2, (short) y).putShort(4, (short) heading);
        return this;
    }

    public SipBytes wheels(int left, int right) {
        data.putShort(6, (short) left).putShort(8, (short) right);
        return this;
    }

    public SipBytes state(int stallBits, int flags) {
        data.put(11, (byte) stallBits).put(12, (byte) (stallBits >> 8)).putShort(15, (short) flags);
        return this;
    }

    public SipBytes sonar(int disc, int range) {
        readings++;
        data.put(18, (byte) readings).put((byte) disc).putShort((short) range);
        return this;
    }

    public SipBytes compass(int twoDegrees) {
        data.put(17, (byte) twoDegrees);
        return this;
    }

    /** What follows the sonar readings, from the gripper's state on. */
    public SipBytes tail(String hex) {
        data.put(Bytes.of(hex));
        return this;
    }

    public byte[] bytes() {
        return Arrays.copyOf(data.array(), data.position());
    }

    public Sip sip() {
        return Bytes.sip(Bytes.hex(Bytes.wire(0x32, bytes())));
    }
}
