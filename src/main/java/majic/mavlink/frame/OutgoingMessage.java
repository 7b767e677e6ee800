package majic.mavlink.frame;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** A message to send: its fields are added in the order of the wire. Used by one thread until it is sent. */
public final class OutgoingMessage {
    private final MavlinkMessageType type;
    private final ByteBuffer bytes;

    /**
     * Begins a message.
     *
     * @param type the message; fields that are not added are zero
     */
    public OutgoingMessage(MavlinkMessageType type) {
        this.type = type;
        this.bytes = ByteBuffer.allocate(type.fullLength()).order(ByteOrder.LITTLE_ENDIAN);
    }

    /** Adds one byte each. */
    public OutgoingMessage u8(int... values) {
        for (int value : values) {
            bytes.put((byte) value);
        }
        return this;
    }

    /** Adds a number of two bytes. */
    public OutgoingMessage u16(int value) {
        bytes.putShort((short) value);
        return this;
    }

    /** Adds a number of four bytes. */
    public OutgoingMessage i32(int value) {
        bytes.putInt(value);
        return this;
    }

    /** Adds numbers with a point, of four bytes each. */
    public OutgoingMessage f32(double... values) {
        for (double value : values) {
            bytes.putFloat((float) value);
        }
        return this;
    }

    /**
     * Adds a text.
     *
     * @param text cut to the length, filled up with zeros
     * @param length of its field
     */
    public OutgoingMessage text(String text, int length) {
        bytes.put(Arrays.copyOf(text.getBytes(StandardCharsets.US_ASCII), length));
        return this;
    }

    /** Returns the message. */
    public MavlinkMessageType type() {
        return type;
    }

    /** The whole payload; a new array. */
    byte[] payload() {
        return bytes.array().clone();
    }
}
