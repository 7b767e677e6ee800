package majic.pioneer.arcos;

/**
 * Counts of what a link has delivered so far. Immutable.
 *
 * @param packets valid packets
 * @param damagedPackets headers followed by a wrong checksum
 * @param skippedBytes bytes outside of valid packets
 */
public record PacketCounts(long packets, long damagedPackets, long skippedBytes) {
    /** Before the first byte. */
    public static final PacketCounts NONE = new PacketCounts(0, 0, 0);
}
