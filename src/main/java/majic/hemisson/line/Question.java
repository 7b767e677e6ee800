package majic.hemisson.line;

import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;

/**
 * A command and the form of its answer (Hemisson sheet 4.3 and 10; both dialects). Immutable.
 *
 * @param text the command without its CR; at most 50 characters (sheet 4.2)
 * @param answer the form of a whole, undamaged answer
 * @param purpose what it is for
 * @param lineMs how long the robot reads nothing else, to the end of the answer, ms (sheet 4.6)
 */
public record Question(String text, Pattern answer, Purpose purpose, double lineMs) {
    /** Longer commands are sometimes corrupted (sheet 4.2). */
    public static final int LONGEST_TEXT = 50;

    /** What takes the line for longer than this would hold up a stop, ms. */
    private static final double LONGEST_IN_MOTION_MS = 5;

    /** A robot in an unknown mode holds two characters, the CR included (sheet 7). */
    private static final int BRIEF = 1;

    private static final double MS_PER_CHARACTER = 0.088;

    /** What a question is for; determines its priority and what happens without an answer. */
    public enum Purpose {
        /** Asks or switches something; may be repeated. */
        ASK,
        /** Makes the wheels turn. */
        MOTION,
        /** Stops the wheels; repeated until it is answered. */
        STOP,
        /** Asks for the speeds after a stop. */
        VERIFY
    }

    private static final String EIGHT_VALUES = "(,\\d{3}){8}";
    private static final double WHEELS_MS = 0.8;

    static final Question VERSION = ask("B", "b,.+", 1.5);
    public static final Question SWITCHES = ask("I", "i(,[01]){4}", 1);
    public static final Question SPEEDS = ask("E", "e(,-?\\d{1,3}){2}", 0.8);
    public static final Question PROXIMITY = ask("N", "n" + EIGHT_VALUES, 3.1);
    public static final Question LIGHT = ask("O", "o" + EIGHT_VALUES, 3.1);
    public static final Question REMOTE = ask("T", "t,\\d{3}", 0.5);
    static final Question MODULES = ask("J", "j(,.*)?", 18);
    static final Question STOP = new Question("D,0,0", wheelsAnswer(), Purpose.STOP, WHEELS_MS);
    static final Question VERIFY = new Question("E", SPEEDS.answer, Purpose.VERIFY, SPEEDS.lineMs);

    /**
     * Shows at connecting that the robot ignores what follows a letter; those behind it are the
     * {@link #STOP_ARGUMENTS}.
     */
    static final Question CARRYING_A_STOP = ask(SPEEDS.carryingAStop(), SPEEDS.answer.pattern(), SPEEDS.lineMs);

    /** What a stop has behind its D. */
    static final String STOP_ARGUMENTS = ",0,0";

    /**
     * A stop behind a question that {@link #carryingAStop carries} its arguments; so brief that it deafens no robot.
     */
    static final String BRIEF_STOP = "D";

    /** A stop that is not repeated, for a robot whose running mode overrides it anyway. */
    static final Question STAND_ONCE = ask("D,0,0", wheelsAnswer().pattern(), WHEELS_MS);

    /** Ends an incomplete command of another program; answered by a refusal (sheet 11). */
    static final Question NOTHING = ask("", "(?!)", 1.6);

    public Question {
        if (text.length() > LONGEST_TEXT || text.indexOf('\r') >= 0 || text.indexOf('\n') >= 0) {
            throw new IllegalArgumentException("no command of the Hemisson: " + text);
        }
    }

    public static Question wheels(MotorValues wheels) {
        return wheels.isStill()
                ? STOP
                : new Question("D," + wheels.left() + "," + wheels.right(), wheelsAnswer(), Purpose.MOTION, WHEELS_MS);
    }

    public static Question buzzer(boolean on) {
        return ask("H," + digit(on), "h(,\\d)?", 0.4);
    }

    public static Question leds(Leds leds) {
        return ask(
                "L," + digit(leds.onOff()) + "," + digit(leds.pgm()) + "," + digit(leds.left()) + ","
                        + digit(leds.right()),
                "l(,\\d){0,4}",
                1);
    }

    /** A question or a command that moves nothing; the answer ends after at most so many ms. */
    public static Question ask(String text, String answer, double lineMs) {
        return new Question(text, Pattern.compile(answer), Purpose.ASK, lineMs);
    }

    /**
     * How long an answer of so many characters is on the line, its end and the robot's processing time included, ms.
     */
    public static double msFor(int characters) {
        return 0.4 + (characters + 2) * MS_PER_CHARACTER;
    }

    /** Whether a stop could not be sent in time behind it. */
    public boolean isLong() {
        return lineMs > LONGEST_IN_MOTION_MS;
    }

    /** Whether the next command survives behind it however soon it comes (sheet 15). */
    boolean isAnsweredBriefly() {
        return !text.isEmpty() && "DHL".indexOf(text.charAt(0)) >= 0;
    }

    /** Whether it reads something by a single letter, so that the robot ignores what follows (sheet 4.2). */
    boolean canCarryAStop() {
        return purpose == Purpose.ASK && text.length() == 1 && Character.isLetter(text.charAt(0));
    }

    /** The same with the arguments of a stop behind it, which the robot keeps for a D without any (sheet 4.2). */
    String carryingAStop() {
        return text + STOP_ARGUMENTS;
    }

    /** Whether it is too short to deafen a robot that does not read it. */
    boolean isBrief() {
        return text.length() <= BRIEF;
    }

    /** The bytes of a command on the wire: the text and one CR, never a LF (sheet 4.1). */
    static byte[] bytes(String text) {
        return (text + "\r").getBytes(StandardCharsets.ISO_8859_1);
    }

    /** The motor values of a command to the wheels. */
    public MotorValues motorValues() {
        String[] parts = text.split(",");
        return new MotorValues(Integer.parseInt(parts[1]), Integer.parseInt(parts[2]));
    }

    /** Whether a reply is the whole answer to this question. */
    boolean isAnsweredBy(Reply reply) {
        return reply.kind() == Reply.Kind.ANSWER && answer.matcher(reply.text()).matches();
    }

    private static Pattern wheelsAnswer() {
        return Pattern.compile("d(,-?\\d{1,2}){0,2}");
    }

    private static char digit(boolean on) {
        return on ? '1' : '0';
    }
}
