package majic.pioneer.arcos;

/**
 * The argument of a command (ARCOS sheet 3, 6). Immutable.
 *
 * @param kind its encoding
 * @param least the smallest number, or the smallest of each of two bytes
 * @param most the largest number, the largest of each of two bytes, or the longest string in bytes
 * @param unit its unit or meaning; empty if there is none
 */
public record CommandArgument(Kind kind, int least, int most, String unit) {
    /** Every firmware accepts signed 16-bit numbers, not all accept more. */
    private static final int WIDEST = 0x7FFF;

    /** Encodings of arguments. */
    public enum Kind {
        /** Nothing follows. */
        NONE,
        /** A number of 16 bits and its sign. */
        INT,
        /** Two bytes in place of a number. */
        TWO_BYTES,
        /** A length and as many bytes. */
        STRING
    }

    static CommandArgument none() {
        return new CommandArgument(Kind.NONE, 0, 0, "");
    }

    static CommandArgument number(int least, int most, String unit) {
        return new CommandArgument(Kind.INT, least, most, unit);
    }

    static CommandArgument size(String unit) {
        return number(0, WIDEST, unit);
    }

    static CommandArgument signed(String unit) {
        return number(-WIDEST, WIDEST, unit);
    }

    static CommandArgument onOff() {
        return number(0, 1, "0 off, 1 on");
    }

    static CommandArgument request() {
        return number(0, 2, "0 stop, 1 once, 2 with every SIP");
    }

    static CommandArgument twoBytes(int least, int most, String unit) {
        return new CommandArgument(Kind.TWO_BYTES, least, most, unit);
    }

    static CommandArgument text(int longest, String unit) {
        return new CommandArgument(Kind.STRING, 0, longest, unit);
    }

    /** Throws {@link IllegalArgumentException} for another kind or a value out of range. */
    void check(ArcosCommand command, Kind given, int... values) {
        if (given != kind) {
            throw new IllegalArgumentException(command + " takes " + kind + ", not " + given);
        }
        for (int value : values) {
            if (value < least || value > most) {
                throw new IllegalArgumentException(command + " takes " + range() + ", not " + value);
            }
        }
    }

    private String range() {
        String counted = unit.isEmpty() ? "" : " (" + unit + ")";
        return kind == Kind.STRING ? "at most " + most + " bytes" : least + " to " + most + counted;
    }
}
