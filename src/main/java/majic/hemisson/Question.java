package majic.hemisson;

import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;

/**
 * One command and what its answer looks like (Hemisson sheet 4.3 and 10; both dialects). Immutable.
 *
 * @param text the command without its CR; at most 50 characters (sheet 4.2)
 * @param answer the form of a whole, undamaged answer
 * @param purpose what it is for
 */
record Question(String text, Pattern answer, Purpose purpose) {
    /** What a question is for; decides who goes first and what becomes of it when no answer comes. */
    enum Purpose {
        /** Asks or switches something; may be repeated. */
        ASK,
        /** Makes the wheels turn. */
        MOTION,
        /** Makes them stand; repeated until it is answered. */
        STOP,
        /** Asks whether they really stand. */
        VERIFY
    }

    private static final String EIGHT_VALUES = "(,\\d{3}){8}";

    static final Question VERSION = ask("B", "b,.+");
    static final Question SWITCHES = ask("I", "i(,[01]){4}");
    static final Question SPEEDS = ask("E", "e(,-?\\d{1,3}){2}");
    static final Question PROXIMITY = ask("N", "n" + EIGHT_VALUES);
    static final Question LIGHT = ask("O", "o" + EIGHT_VALUES);
    static final Question STOP = new Question("D,0,0", wheelsAnswer(), Purpose.STOP);
    static final Question VERIFY = new Question("E", SPEEDS.answer, Purpose.VERIFY);

    /** Ends half a command that somebody else left behind; answered by a refusal (sheet 11). */
    static final Question NOTHING = ask("", "(?!)");

    static Question wheels(Wheels wheels) {
        return wheels.isStill()
                ? STOP
                : new Question("D," + wheels.left() + "," + wheels.right(), wheelsAnswer(), Purpose.MOTION);
    }

    static Question buzzer(boolean on) {
        return ask("H," + digit(on), "h(,\\d)?");
    }

    static Question leds(Leds leds) {
        return ask(
                "L," + digit(leds.onOff()) + "," + digit(leds.pgm()) + "," + digit(leds.left()) + ","
                        + digit(leds.right()),
                "l(,\\d){0,4}");
    }

    /** The bytes on the wire: the text and one CR, never a LF (sheet 4.1). */
    byte[] bytes() {
        return (text + "\r").getBytes(StandardCharsets.ISO_8859_1);
    }

    /** What a command to the wheels tells them. */
    Wheels told() {
        String[] parts = text.split(",");
        return new Wheels(Integer.parseInt(parts[1]), Integer.parseInt(parts[2]));
    }

    /** Whether a reply is the whole answer to this question. */
    boolean isAnsweredBy(Reply reply) {
        return reply.kind() == Reply.Kind.ANSWER && answer.matcher(reply.text()).matches();
    }

    private static Question ask(String text, String answer) {
        return new Question(text, Pattern.compile(answer), Purpose.ASK);
    }

    private static Pattern wheelsAnswer() {
        return Pattern.compile("d(,-?\\d{1,2}){0,2}");
    }

    private static char digit(boolean on) {
        return on ? '1' : '0';
    }
}
