package majicsim.pioneer.packet;

/**
 * One packet from the client whose checksum was right.
 *
 * @param id the command's number, 0 to 255
 * @param data what stands between id and checksum; not copied, and never changed
 */
public record Packet(int id, byte[] data) {}
