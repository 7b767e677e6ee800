package majic.mavlink.frame;

import java.util.concurrent.atomic.AtomicInteger;

/** Makes the frames that a ground station sends to one peer, with sequence numbers of their own. Thread-safe. */
public final class MavlinkEncoder {
    /** The system of a ground station. */
    public static final int SYSTEM = 255;

    /** The component of a ground station. */
    public static final int COMPONENT = 190;

    static final int START_1 = 0xFE;
    static final int START_2 = 0xFD;
    static final int HEADER_1 = 6;
    static final int HEADER_2 = 10;
    static final int CRC_LENGTH = 2;

    private final AtomicInteger sequence = new AtomicInteger();

    /** Begins with sequence number 0. */
    public MavlinkEncoder() {}

    /**
     * Makes the next frame.
     *
     * @param message the message
     * @param version 1 for a vehicle that knows only MAVLink 1, otherwise 2
     * @return the bytes of the frame
     * @throws IllegalArgumentException if MAVLink 1 has no such message
     */
    public byte[] encode(OutgoingMessage message, int version) {
        return encode(message, version, sequence.getAndIncrement() & 0xFF);
    }

    static byte[] encode(OutgoingMessage message, int version, int number) {
        MavlinkMessageType type = message.type();
        byte[] payload = message.payload();
        if (version == 1) {
            if (type.id() > 0xFF) {
                throw new IllegalArgumentException(type + " is no message of MAVLink 1");
            }
            byte[] frame = frame(HEADER_1, START_1, payload, type.baseLength());
            frame[2] = (byte) number;
            frame[3] = (byte) SYSTEM;
            frame[4] = (byte) COMPONENT;
            frame[5] = (byte) type.id();
            return checked(frame, type);
        }
        byte[] frame = frame(HEADER_2, START_2, payload, trimmed(payload));
        frame[4] = (byte) number;
        frame[5] = (byte) SYSTEM;
        frame[6] = (byte) COMPONENT;
        frame[7] = (byte) type.id();
        frame[8] = (byte) (type.id() >>> 8);
        frame[9] = (byte) (type.id() >>> 16);
        return checked(frame, type);
    }

    /** Zeros at the end are left out; one byte stays. */
    private static int trimmed(byte[] payload) {
        int length = payload.length;
        while (length > 1 && payload[length - 1] == 0) {
            length--;
        }
        return length;
    }

    private static byte[] frame(int header, int start, byte[] payload, int length) {
        byte[] frame = new byte[header + length + CRC_LENGTH];
        frame[0] = (byte) start;
        frame[1] = (byte) length;
        System.arraycopy(payload, 0, frame, header, length);
        return frame;
    }

    private static byte[] checked(byte[] frame, MavlinkMessageType type) {
        int end = frame.length - CRC_LENGTH;
        int crc = X25.of(frame, 1, end, type.crcExtra());
        frame[end] = (byte) crc;
        frame[end + 1] = (byte) (crc >>> 8);
        return frame;
    }
}
