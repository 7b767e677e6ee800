package majic.aibo.urbi;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Looks at a raw command before it may go out. Beside what is harmful from anybody it refuses what would leave the
 * server waiting for the rest of it, or close connections (URBI sheet 3, 9, 12).
 */
public final class RawText {
    private static final Pattern CLOSES = Pattern.compile("(?<![\\w.])(?:quit|disconnect|killall)(?![\\w.])");
    private static final Pattern BLEND_OF_LEGS = Pattern.compile("leg\\w*(?:\\.val)?\\s*->\\s*blend\\s*=");
    private static final Pattern BINARY = Pattern.compile("(?<![\\w.])(?:BIN|bin)\\s+\\d");
    private static final String OPENING = "([{";
    private static final String CLOSING = ")]}";

    private RawText() {}

    /**
     * Lets a text pass that is whole in itself.
     *
     * @return it, without what ends it
     * @throws UrbiRefusal if the server could not make sense of it; nothing is to be sent then
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
