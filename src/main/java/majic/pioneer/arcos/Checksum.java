package majic.pioneer.arcos;

/** The sum over a packet's type and data (ARCOS sheet 2.1). */
final class Checksum {
    private Checksum() {}

    /**
     * Sums bytes up in pairs, the first of each pair high; a last single byte is XORed in.
     *
     * @param from index of the packet's type
     * @param end index behind the last data byte
     */
    static int of(byte[] bytes, int from, int end) {
        int sum = 0;
        int at = from;
        for (; at + 1 < end; at += 2) {
            sum += (bytes[at] & 0xFF) << 8 | bytes[at + 1] & 0xFF;
        }
        return (at < end ? sum ^ bytes[at] & 0xFF : sum) & 0xFFFF;
    }
}
