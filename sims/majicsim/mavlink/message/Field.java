package majicsim.mavlink.message;

/** A field of a message: {@code count} values of a type, from a byte of the payload on. */
record Field(FieldType type, String name, int count, boolean isArray, boolean isExtension, int offset) {

    /** Parses a definition as {@code uint16_t voltages[10]}. */
    static Field parse(String definition, boolean isExtension, int offset) {
        String[] words = definition.strip().split("[ \\[\\]]");
        boolean isArray = words.length > 2;
        int count = isArray ? Integer.parseInt(words[2]) : 1;
        return new Field(FieldType.named(words[0]), words[1], count, isArray, isExtension, offset);
    }

    int end() {
        return offset + count * type.bytes();
    }

    /** Where one of its values is in the payload. */
    int at(int index) {
        if (index < 0 || index >= count) {
            throw new IllegalArgumentException(name + " has " + count + " values, not one of number " + index);
        }
        return offset + index * type.bytes();
    }
}
