package majicsim.pioneer.packet;

/** The sum that ends every ARCOS packet (ARCOS sheet 2.1): pairs added modulo 65536, a last odd byte XORed in. */
final class Checksum {
    private Checksum() {}

    /**
     * Sums the bytes from {@code start} up to, not including, {@code end}: a packet's id and data.
     *
     * @return 0 to 65535; goes on the wire high byte first
     */
    static int of(byte[] bytes, int start, int end) {
        int sum = 0;
        int at = start;
        for (; at + 1 < end; at += 2) {
            sum = sum + ((bytes[at] & 0xFF) << 8) + (bytes[at + 1] & 0xFF) & 0xFFFF;
        }
        return at < end ? sum ^ bytes[at] & 0xFF : sum;
    }
}
