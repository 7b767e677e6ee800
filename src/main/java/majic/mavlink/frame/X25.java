package majic.mavlink.frame;

/** The checksum of a frame: CRC-16 with the reflected polynomial 8408, from FFFF, without a final inversion. */
final class X25 {
    private static final int START = 0xFFFF;
    private static final int POLYNOMIAL = 0x8408;

    private X25() {}

    /**
     * Computes the checksum of a frame.
     *
     * @param bytes the frame
     * @param from index of its second byte
     * @param end index behind the payload
     * @param extra the byte of the message
     */
    static int of(byte[] bytes, int from, int end, int extra) {
        int crc = START;
        for (int index = from; index < end; index++) {
            crc = add(crc, bytes[index] & 0xFF);
        }
        return add(crc, extra);
    }

    private static int add(int crc, int value) {
        int next = crc ^ value;
        for (int bit = 0; bit < 8; bit++) {
            next = (next & 1) == 0 ? next >>> 1 : next >>> 1 ^ POLYNOMIAL;
        }
        return next;
    }
}
