package majic.hemisson.line;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;

/** The errors of a {@link Handshake}: what is wrong by what was received, and what would be right. */
final class HandshakeErrors {
    /** What comes back of the questions that {@link Handshake} sends first, without their line ends. */
    private static final Pattern ECHO = Pattern.compile("B+");

    /** Line ends, and how a terminal that echoes shows them. */
    private static final Pattern LINE_END = Pattern.compile("\\^M|[\\r\\n]");

    /** Pieces of the answers to these questions (Hemisson sheet 4.3). */
    private static final Pattern PIECE =
            Pattern.compile("b,He?|,Hem|emiO|OS_v|v_1\\.|Unkn|know|nown|Comm|mman|nd \\?|\\?!");

    private static final int MOST_SHOWN = 8;
    private static final String ANOTHER_PROGRAM = "another program that has the port open takes the others; end it";

    private final HemissonSession session;

    HandshakeErrors(HemissonSession session) {
        this.session = session;
    }

    ConnectFailed telnet() {
        return wrongDevice("what answers there speaks telnet (RFC 2217), not a raw serial line; "
                + "can the serial server be set to raw TCP?");
    }

    BotException closed() {
        String end = session.end();
        if (end == null) {
            return new BotException("closed while connecting");
        }
        if (!session.isOnNetwork()) {
            return new BotException("the connection was lost at once: " + end);
        }
        return session.firstBytes().isWebServer() ? otherDevice() : busy(end);
    }

    private ConnectFailed busy(String end) {
        String line = session.firstBytes().line();
        return new ConnectFailed(
                Reason.BUSY,
                "the connection was lost at once: " + end + (line == null ? "" : ", saying \"" + line + "\"")
                        + "; is another program connected to it?");
    }

    ConnectFailed noStop(double seconds) {
        return new ConnectFailed(
                Reason.NO_ANSWER,
                "it answers, but does not confirm a stop within " + seconds
                        + " s; lift it, switch it off, wait 5 s and switch it on again, and end other programs that use "
                        + "the port");
    }

    /** None of the first questions was answered. */
    ConnectFailed noVersion() {
        String received = session.firstBytes().text();
        if (received.isEmpty()) {
            return silent();
        }
        if (ECHO.matcher(LINE_END.matcher(received).replaceAll("")).matches()) {
            return wrongDevice(
                    "only MAJIC's own questions come back: the port echoes, as one without a robot may do; is "
                            + "it the right port? A Hemisson that echoes is in BotStudio's upload: switch it off, wait 5 s, "
                            + "switch it on");
        }
        Matcher piece = PIECE.matcher(received);
        if (session.isRecognised() || piece.find()) {
            return new ConnectFailed(
                    Reason.BUSY, "a Hemisson answers there, but not all of its answers arrive: " + ANOTHER_PROGRAM);
        }
        return session.firstBytes().line() == null ? noText(received) : otherDevice();
    }

    private static ConnectFailed silent() {
        return new ConnectFailed(
                Reason.NO_ANSWER,
                "nothing comes from there; is it the right port, and the robot on, in the Exec position? A Hemisson that "
                        + "no longer receives anything needs a restart: switch it off, wait 5 s, switch it on. If answers "
                        + "are missing, " + ANOTHER_PROGRAM);
    }

    private static ConnectFailed noText(String received) {
        String first = received.chars()
                .limit(MOST_SHOWN)
                .mapToObj(code -> String.format(Locale.ROOT, "%02X", code))
                .collect(Collectors.joining(" "));
        return wrongDevice("what comes from there is no answer of a Hemisson (in hex: " + first
                + (received.length() > MOST_SHOWN ? " …" : "")
                + "); is it the right port? A device that does not send at 115200 baud looks like this");
    }

    private ConnectFailed otherDevice() {
        return wrongDevice("something answers there, but not as a Hemisson does; it says \""
                + session.firstBytes().line() + "\"; is it the right port?");
    }

    private static ConnectFailed wrongDevice(String message) {
        return new ConnectFailed(Reason.WRONG_DEVICE, message);
    }
}
