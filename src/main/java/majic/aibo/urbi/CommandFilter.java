package majic.aibo.urbi;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Refuses commands that must never reach a dog, from any source: they make the server unusable, end what other programs
 * run, or disconnect a joint from its motor (URBI sheet 5, 9, 19 "Never send").
 */
final class CommandFilter {
    /** The longest command; a server drops what is longer than its queue of 32 KiB (URBI sheet 2). */
    static final int LONGEST_BYTES = 32_000;

    private static final Pattern RUNS_TEXT = Pattern.compile("\\bexec\\b");
    private static final Pattern HARMFUL =
            Pattern.compile("(?<![\\w.])(?:undefall|stopall|reset|reboot|shutdown|stop\\s[\\w\\s.,]*\\bnotag)(?![\\w.])"
                    + "|->\\s*unit\\b");
    private static final Pattern TEXT_TO_A_DEVICE = Pattern.compile(
            "(?<![\\w.])(?:head|headPan|headTilt|neck|mouth|tail\\w*|leg\\w+|ear\\w+|led\\w+|mode[RGB]|motors?)"
                    + "(?:\\.val)?\\s*=\\s*\"");

    private CommandFilter() {}

    /**
     * Checks that commands may be sent.
     *
     * @throws UrbiRefusal if they may not; nothing is to be sent then
     */
    static void check(String commands) {
        if (commands.length() >= LONGEST_BYTES) {
            throw new UrbiRefusal("a command of " + commands.length() + " bytes is too long for the dog, which takes "
                    + LONGEST_BYTES + " at most");
        }
        String bare = UrbiProgram.of(commands).bare();
        refuse(
                HARMFUL.matcher(RUNS_TEXT.matcher(bare).find() ? commands : bare),
                "it would harm the dog or other programs on it");
        refuse(TEXT_TO_A_DEVICE.matcher(bare), "text would take the device from its hardware; give a number");
    }

    private static void refuse(Matcher found, String why) {
        if (found.find()) {
            throw new UrbiRefusal("\"" + found.group().strip() + "\" is never sent to a dog: " + why);
        }
    }
}
