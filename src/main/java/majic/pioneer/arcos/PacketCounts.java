package majic.pioneer.arcos;

/**
 * How well a link has carried the robot's bytes so far. Immutable.
 *
 * @param packets packets that came whole
 * @param damagedPackets headers whose packet did not fit its checksum
 * @param skippedBytes bytes that belonged to no whole packet, those of damaged ones included
 */
public record PacketCounts(long packets, long damagedPackets, long skippedBytes) {
    /** Before the first byte. */
    public static final PacketCounts NONE = new PacketCounts(0, 0, 0);
}
