package majic.hemisson.line;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * One line from the robot. Immutable.
 *
 * @param kind what sort of line it is
 * @param text the line without its end
 */
public record Reply(Kind kind, String text) {
    private static final Pattern ANSWER = Pattern.compile("[a-z0-9!&*](,.*)?", Pattern.DOTALL);
    private static final Pattern NUMBER = Pattern.compile("-?\\d{1,4}");

    /** What sort of line came. */
    public enum Kind {
        /** The answer to a command: its letter in lower case, usually with values. */
        ANSWER,
        /** The robot refused a command; both dialects (sheet 4.5 and 10). */
        REFUSED,
        /** The first line after power-up or reset (sheet 3). */
        GREETING,
        /** Anything else: the rest of a greeting, or noise. */
        OTHER
    }

    public static Reply of(String line) {
        if (line.startsWith("HemiOS")) {
            return new Reply(Kind.GREETING, line);
        }
        if (line.startsWith("Unknown Command") || line.startsWith("<E")) {
            return new Reply(Kind.REFUSED, line);
        }
        return new Reply(ANSWER.matcher(line).matches() ? Kind.ANSWER : Kind.OTHER, line);
    }

    /** Whether only a Hemisson is likely to send it; a single letter can be noise. */
    boolean isTypical() {
        return kind == Kind.ANSWER ? text.length() > 2 : kind != Kind.OTHER;
    }

    /** All whole numbers in the line, in order: {@code e,05,-5} holds 5 and -5. */
    public List<Integer> numbers() {
        List<Integer> numbers = new ArrayList<>();
        for (Matcher found = NUMBER.matcher(text); found.find(); ) {
            numbers.add(Integer.parseInt(found.group()));
        }
        return numbers;
    }

    /** The text behind the letter and the comma; empty if there is none. */
    public String rest() {
        return text.length() > 2 ? text.substring(2) : "";
    }
}
