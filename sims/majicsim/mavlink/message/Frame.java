package majicsim.mavlink.message;

/**
 * A message on the wire (sheet 2).
 *
 * @param version of MAVLink, 1 or 2
 * @param sequence number among the frames of its sender, 0 to 255
 * @param system id of the sender
 * @param component id of the sender
 * @param message what it says
 */
public record Frame(int version, int sequence, int system, int component, Message message) {
    static final int MAGIC_V1 = 0xFE;
    static final int MAGIC_V2 = 0xFD;
    static final int HEADER_V1 = 6;
    static final int HEADER_V2 = 10;
    static final int CHECKSUM = 2;
    static final int SIGNATURE = 13;

    /**
     * Checks the version.
     *
     * @throws IllegalArgumentException if there is no such version, or version 1 has no such message
     */
    public Frame {
        if (version != 1 && version != 2) {
            throw new IllegalArgumentException("MAVLink has versions 1 and 2, not " + version);
        }
        if (version == 1 && message.type().id() > 255) {
            throw new IllegalArgumentException("MAVLink 1 has no " + message.type());
        }
    }

    /**
     * The frame as bytes, unsigned.
     *
     * @return header, payload and checksum
     */
    public byte[] toBytes() {
        byte[] payload = message.payload(version);
        int header = version == 1 ? HEADER_V1 : HEADER_V2;
        byte[] bytes = new byte[header + payload.length + CHECKSUM];
        int id = message.type().id();
        int[] start = version == 1
                ? new int[] {MAGIC_V1, payload.length, sequence, system, component, id}
                : new int[] {MAGIC_V2, payload.length, 0, 0, sequence, system, component, id, id >> 8, id >> 16};
        for (int i = 0; i < header; i++) {
            bytes[i] = (byte) start[i];
        }
        System.arraycopy(payload, 0, bytes, header, payload.length);
        int end = header + payload.length;
        int checksum =
                new Checksum().add(bytes, 1, end).add(message.type().crcExtra()).value();
        bytes[end] = (byte) checksum;
        bytes[end + 1] = (byte) (checksum >> 8);
        return bytes;
    }
}
