package majicsim.ros.message;

import java.util.Set;

/**
 * The type of one field.
 *
 * @param element a built-in type, or package and name of a message
 * @param length {@link #SCALAR}, {@link #VARIABLE}, or the number of elements of a fixed array
 */
record FieldType(String element, int length) {
    static final int SCALAR = -1;
    static final int VARIABLE = 0;

    private static final Set<String> FLOATS = Set.of("float32", "float64");
    private static final Set<String> OTHERS = Set.of(
            "bool", "string", "time", "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "byte",
            "char");

    /** Parses {@code float64}, {@code float64[]} or {@code float64[36]}. */
    static FieldType parse(String text) {
        int bracket = text.indexOf('[');
        if (bracket < 0) {
            return new FieldType(text, SCALAR);
        }
        String length = text.substring(bracket + 1, text.length() - 1);
        return new FieldType(text.substring(0, bracket), length.isEmpty() ? VARIABLE : Integer.parseInt(length));
    }

    boolean isArray() {
        return length != SCALAR;
    }

    boolean isFixed() {
        return length > 0;
    }

    boolean isFloat() {
        return FLOATS.contains(element);
    }

    boolean isBuiltIn() {
        return isFloat() || OTHERS.contains(element);
    }

    /** Whether the array is sent as one base64 text (sheet 4). */
    boolean isBytes() {
        return isArray() && (element.equals("uint8") || element.equals("char"));
    }

    FieldType ofElement() {
        return new FieldType(element, SCALAR);
    }
}
