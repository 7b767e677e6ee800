package majicsim.hemisson.firmware;

import java.util.Locale;

/** Reads arguments of module commands of the RoadNarrows dialect, and writes their values. */
final class Arguments {
    private Arguments() {}

    /** Reads hex digits in upper or lower case, as many as given. */
    static int hex(String text, int digits) throws ErrorReplyException {
        return number(text, "[0-9A-Fa-f]{" + digits + "}", 16);
    }

    /** One or two decimal digits of a range. */
    static int decimal(String text, int least, int most) throws ErrorReplyException {
        int value = number(text, "[0-9]{1,2}", 10);
        if (value < least || value > most) {
            throw new ErrorReplyException(ErrorReply.RANGE);
        }
        return value;
    }

    static String hex2(int value) {
        return String.format(Locale.ROOT, "%02X", value & 0xFF);
    }

    static String hex4(int value) {
        return String.format(Locale.ROOT, "%04X", value & 0xFFFF);
    }

    private static int number(String text, String form, int radix) throws ErrorReplyException {
        if (!text.matches(form)) {
            throw new ErrorReplyException(ErrorReply.SYNTAX);
        }
        return Integer.parseInt(text, radix);
    }
}
