package majic.aibo.urbi;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Checks a raw command before it may be sent. Besides the commands that {@link CommandFilter} refuses, it refuses those
 * that would leave the server waiting for the rest, and those that close connections (URBI sheet 3, 9, 12).
 */
public final class RawText {
    private static final Pattern CLOSES = Pattern.compile("(?<![\\w.])(?:quit|disconnect|killall)(?![\\w.])");
    private static final Pattern BLEND_OF_LEGS = Pattern.compile("leg\\w*(?:\\.val)?\\s*->\\s*blend\\s*=");
    private static final Pattern BINARY = Pattern.compile("(?<![\\w.])(?:BIN|bin)\\s+\\d");
    private static final String OPENING = "([{";
    private static final String CLOSING = ")]}";

    private RawText() {}

    /**
     * Checks that a text is complete in itself.
     *
     * @return the text, without the separators at its end
     * @throws UrbiRefusal if it is refused; nothing may be sent then
     */
    public static String checked(String text) {
        CommandFilter.check(text);
        UrbiProgram program = UrbiProgram.of(text);
        String bare = program.bare();
        if (program.hasComments() || bare.contains("$$")) {
            throw new UrbiRefusal("comments and $$ would swallow what follows; leave them out");
        }
        if (program.isOpen()) {
            throw new UrbiRefusal("a quote is not closed: the dog would wait for its end");
        }
        if (!isBalanced(bare)) {
            throw new UrbiRefusal("the brackets do not match: the dog would wait for the rest");
        }
        refuse(CLOSES.matcher(bare), "it closes connections; \"remove\" does so for this one");
        refuse(BLEND_OF_LEGS.matcher(bare), "the gaits need it as it is");
        refuse(BINARY.matcher(bare), "a typed line carries no bytes");
        return text.strip().replaceFirst("[;\\s]+$", "");
    }

    private static void refuse(Matcher found, String why) {
        if (found.find()) {
            throw new UrbiRefusal("\"" + found.group().strip() + "\" is not sent: " + why);
        }
    }

    private static boolean isBalanced(String text) {
        Deque<Character> open = new ArrayDeque<>();
        for (char next : text.toCharArray()) {
            if (OPENING.indexOf(next) >= 0) {
                open.push(next);
            } else if (CLOSING.indexOf(next) >= 0
                    && (open.isEmpty() || open.pop() != OPENING.charAt(CLOSING.indexOf(next)))) {
                return false;
            }
        }
        return open.isEmpty();
    }
}
