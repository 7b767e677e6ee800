package majicsim.mavlink.message;

/** The types of fields, by their names in the message definitions. Numbers are little-endian. */
enum FieldType {
    CHAR("char", 1),
    UINT8("uint8_t", 1),
    INT8("int8_t", 1),
    UINT16("uint16_t", 2),
    INT16("int16_t", 2),
    UINT32("uint32_t", 4),
    INT32("int32_t", 4),
    FLOAT("float", 4),
    UINT64("uint64_t", 8),
    INT64("int64_t", 8);

    private final String definitionName;
    private final int bytes;

    FieldType(String definitionName, int bytes) {
        this.definitionName = definitionName;
        this.bytes = bytes;
    }

    static FieldType named(String definitionName) {
        for (FieldType type : values()) {
            if (type.definitionName.equals(definitionName)) {
                return type;
            }
        }
        throw new IllegalArgumentException("no type of a field: " + definitionName);
    }

    String definitionName() {
        return definitionName;
    }

    int bytes() {
        return bytes;
    }

    private boolean isSigned() {
        return this == INT8 || this == INT16 || this == INT32;
    }

    long integer(byte[] payload, int offset) {
        long value = 0;
        for (int i = bytes - 1; i >= 0; i--) {
            value = value << 8 | payload[offset + i] & 0xFF;
        }
        int unused = 64 - 8 * bytes;
        return isSigned() ? value << unused >> unused : value;
    }

    double number(byte[] payload, int offset) {
        long value = integer(payload, offset);
        return this == FLOAT ? Float.intBitsToFloat((int) value) : value;
    }

    void putInteger(byte[] payload, int offset, long value) {
        for (int i = 0; i < bytes; i++) {
            payload[offset + i] = (byte) (value >> 8 * i);
        }
    }

    /** Writes a number; into a field for integers the nearest one. */
    void putNumber(byte[] payload, int offset, double value) {
        putInteger(payload, offset, this == FLOAT ? Float.floatToRawIntBits((float) value) : Math.round(value));
    }
}
