package majicsim.hemisson.firmware;

import java.util.Locale;
import majicsim.hemisson.uart.Reply;

/** Error replies of the RoadNarrows dialect (sheet 10); only their numbers are documented. */
enum ErrorReply {
    UNKNOWN_COMMAND(1, "unknown command"),
    SYNTAX(2, "bad syntax"),
    OVERFLOW(3, "command too long"),
    BAD_MODULE(11, "bad module id"),
    NOT_CONNECTED(12, "module not connected"),
    NOT_SUPPORTED(13, "module not supported"),
    BUSY(14, "module busy"),
    LENGTH(15, "bad length"),
    RANGE(16, "value out of range"),
    UNKNOWN_MODULE_COMMAND(17, "unknown module command");

    private final String line;

    ErrorReply(int number, String words) {
        line = String.format(Locale.ROOT, "<E%02d: %s>", number, words);
    }

    Reply reply() {
        return Reply.line(line);
    }
}
