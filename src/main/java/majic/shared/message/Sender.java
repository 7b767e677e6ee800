package majic.shared.message;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.UUID;
import java.util.regex.Pattern;
import majic.bot.BotException;
import majic.text.VisibleText;

/**
 * The sender of a message: one run of one program, with the names of its desk and user. The session is the proof that a
 * program holds a robot, and is sent to the desk of the robot only; all others see its hash. Immutable.
 *
 * @param desk the name of the desk; a program that shares nothing has one too
 * @param person the name that is shown to others
 * @param session a random text that no other run of a program has, at most 64 characters
 */
public record Sender(String desk, String person, String session) {
    private static final int LONGEST = 64;
    private static final int LONGEST_PERSON = 40;
    private static final int HASH_BYTES = 8;
    private static final Pattern DESK = Pattern.compile("\\p{L}[\\p{L}\\d_-]{0,19}");
    private static final Pattern SESSION = Pattern.compile("[\\w-]{1," + LONGEST + "}");

    /**
     * A sender of this run of this program.
     *
     * @param desk its name
     * @param person the name of its user
     * @return with a session of its own
     * @throws BotException if the desk's name cannot be one
     */
    public static Sender ofThisRun(String desk, String person) {
        checkDesk(desk);
        return new Sender(desk, shown(person), UUID.randomUUID().toString());
    }

    /**
     * Checks the name of a desk.
     *
     * @param desk the name
     * @throws BotException if it cannot be one
     */
    public static void checkDesk(String desk) {
        if (!isDesk(desk)) {
            throw new BotException(VisibleText.of(desk)
                    + ": the name of a desk is a letter, then letters, digits, - and _, at most 20 characters in all");
        }
    }

    /**
     * Returns whether a text can be the name of a desk.
     *
     * @param text any
     * @return true for a letter, then letters, digits, - and _, at most 20 characters in all
     */
    public static boolean isDesk(String text) {
        return DESK.matcher(text).matches();
    }

    /**
     * Returns what others see in place of the session, from which the session cannot be derived.
     *
     * @return the first 8 bytes of the SHA-256 hash of the session in UTF-8, as 16 hexadecimal digits in lower case
     */
    public String sessionHash() {
        try {
            byte[] hash = MessageDigest.getInstance("SHA-256").digest(session.getBytes(StandardCharsets.UTF_8));
            return HexFormat.of().formatHex(hash, 0, HASH_BYTES);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Returns the name in messages: {@code Anna at desk1}. */
    @Override
    public String toString() {
        return person.isEmpty() ? desk : person + " at " + desk;
    }

    /** Without the desk if its program has named none. */
    void write(ObjectNode to) {
        to.put("session", session).put("person", person);
        if (isDesk(desk)) {
            to.put("desk", desk);
        }
    }

    /** Reads the fields; {@code desk} and {@code person} may be missing. */
    static Sender read(JsonObject from) {
        String session = from.text("session");
        if (!SESSION.matcher(session).matches()) {
            throw from.wrong("session", "it is 1 to " + LONGEST + " letters, digits, - and _");
        }
        String desk = from.text("desk", "");
        if (from.has("desk") && !isDesk(desk)) {
            throw from.wrong("desk", "it is a letter, then letters, digits, - and _, at most 20 characters in all");
        }
        Sender sender = new Sender(desk, shown(from.text("person", "")), session);
        return desk.isEmpty() ? sender.named("session " + sender.sessionHash().substring(0, 8)) : sender;
    }

    private Sender named(String newDesk) {
        return new Sender(newDesk, person, session);
    }

    private static String shown(String person) {
        return VisibleText.beginning(VisibleText.of(person).strip(), LONGEST_PERSON)
                .strip();
    }
}
