package majicsim.pioneer.serial;

import java.io.ByteArrayOutputStream;

/**
 * Computes the bytes that one end of a serial line reads if the other end sends at another speed. Each byte goes over
 * the wire as a low start bit, eight bits with the lowest first, and a high stop bit; the reader looks for a falling
 * edge and samples at its own pace from there.
 */
final class SerialBits {
    private static final int BITS_A_BYTE = 10;

    private final byte[] sent;

    private SerialBits(byte[] sent) {
        this.sent = sent;
    }

    /** The bytes as they are read at {@code readBaud}: the same at equal speeds, wrong ones otherwise. */
    static byte[] heard(byte[] sent, int sentBaud, int readBaud) {
        return sentBaud == readBaud ? sent : new SerialBits(sent).sampled((double) sentBaud / readBaud);
    }

    /** Reads with bits that are {@code pace} bits of the sender long. */
    private byte[] sampled(double pace) {
        ByteArrayOutputStream heard = new ByteArrayOutputStream();
        double start = nextEdge(0);
        while (start < sent.length * BITS_A_BYTE) {
            boolean stopped = isHigh(start + 9.5 * pace);
            heard.write(stopped ? byteAt(start, pace) : 0);
            start = nextEdge(start + 9.5 * pace);
        }
        return heard.toByteArray();
    }

    private int byteAt(double start, double pace) {
        int value = 0;
        for (int bit = 0; bit < 8; bit++) {
            value |= isHigh(start + (1.5 + bit) * pace) ? 1 << bit : 0;
        }
        return value;
    }

    /** Where the line falls next, in the sender's bits; behind the end if it never does. */
    private double nextEdge(double from) {
        int bit = (int) Math.floor(from);
        while (bit < sent.length * BITS_A_BYTE && !(isHigh(bit - 0.5) && !isHigh(bit + 0.5) && bit >= from)) {
            bit++;
        }
        return bit;
    }

    private boolean isHigh(double at) {
        int bit = (int) Math.floor(at);
        if (bit < 0 || bit >= sent.length * BITS_A_BYTE) {
            return true;
        }
        int place = bit % BITS_A_BYTE;
        return place == BITS_A_BYTE - 1 || place > 0 && (sent[bit / BITS_A_BYTE] >> (place - 1) & 1) == 1;
    }
}
