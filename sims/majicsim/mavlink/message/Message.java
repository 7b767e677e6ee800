package majicsim.mavlink.message;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** A message with the values of its fields, by the names of the definitions. Not thread-safe. */
public final class Message {
    private final MessageType type;
    private final byte[] payload;

    /**
     * A message whose fields are all zero.
     *
     * @param type its type
     */
    public Message(MessageType type) {
        this(type, new byte[0]);
    }

    /** A message with this payload, which may be truncated or too long. */
    Message(MessageType type, byte[] payload) {
        this.type = type;
        this.payload = Arrays.copyOf(payload, type.length());
    }

    /**
     * What kind of message it is.
     *
     * @return its type
     */
    public MessageType type() {
        return type;
    }

    /**
     * Sets a field.
     *
     * @param field its name
     * @param value the number; of an integer too large for the field only the low bits are taken
     * @return this
     * @throws IllegalArgumentException if there is no such field
     */
    public Message with(String field, long value) {
        Field at = type.field(field);
        if (at.type() == FieldType.FLOAT) {
            return with(field, (double) value);
        }
        at.type().putInteger(payload, at.offset(), value);
        return this;
    }

    /**
     * Sets a field.
     *
     * @param field its name
     * @param value the number, rounded for an integer
     * @return this
     * @throws IllegalArgumentException if there is no such field
     */
    public Message with(String field, double value) {
        return with(field, 0, value);
    }

    /**
     * Sets one value of an array.
     *
     * @param field its name
     * @param index from 0
     * @param value the number, rounded for an integer
     * @return this
     * @throws IllegalArgumentException if there is no such field or index
     */
    public Message with(String field, int index, double value) {
        Field at = type.field(field);
        at.type().putNumber(payload, at.at(index), value);
        return this;
    }

    /**
     * Sets a text; what is longer than the field is cut off, and a shorter one is followed by NULs.
     *
     * @param field its name
     * @param text Latin-1
     * @return this
     * @throws IllegalArgumentException if there is no such field
     */
    public Message with(String field, String text) {
        Field at = type.field(field);
        byte[] bytes = Arrays.copyOf(text.getBytes(StandardCharsets.ISO_8859_1), at.count());
        System.arraycopy(bytes, 0, payload, at.offset(), at.count());
        return this;
    }

    /**
     * The value of a field.
     *
     * @param field its name
     * @return the number
     * @throws IllegalArgumentException if there is no such field
     */
    public double number(String field) {
        return number(field, 0);
    }

    /**
     * One value of an array.
     *
     * @param field its name
     * @param index from 0
     * @return the number
     * @throws IllegalArgumentException if there is no such field or index
     */
    public double number(String field, int index) {
        Field at = type.field(field);
        return at.type().number(payload, at.at(index));
    }

    /**
     * The value of an integer field.
     *
     * @param field its name
     * @return the number; the low 32 bits of a longer one
     * @throws IllegalArgumentException if there is no such field
     */
    public int integer(String field) {
        Field at = type.field(field);
        return (int) at.type().integer(payload, at.offset());
    }

    /**
     * The value of a text.
     *
     * @param field its name
     * @return the characters before the first NUL
     * @throws IllegalArgumentException if there is no such field
     */
    public String text(String field) {
        Field at = type.field(field);
        int end = at.offset();
        while (end < at.end() && payload[end] != 0) {
            end++;
        }
        return new String(payload, at.offset(), end - at.offset(), StandardCharsets.ISO_8859_1);
    }

    /**
     * Whether the message has a field.
     *
     * @param field its name
     * @return false if its type has none of this name
     */
    public boolean has(String field) {
        return type.has(field);
    }

    /** The payload of a version: without extensions in version 1, without the zeros at its end in version 2. */
    byte[] payload(int version) {
        if (version == 1) {
            return Arrays.copyOf(payload, type.baseLength());
        }
        int end = payload.length;
        while (end > 1 && payload[end - 1] == 0) {
            end--;
        }
        return Arrays.copyOf(payload, end);
    }

    @Override
    public String toString() {
        StringBuilder text = new StringBuilder(type.name());
        for (Field field : type.fields()) {
            text.append(' ').append(field.name()).append('=');
            text.append(field.type() == FieldType.CHAR ? text(field.name()) : String.valueOf(number(field.name())));
        }
        return text.toString();
    }
}
