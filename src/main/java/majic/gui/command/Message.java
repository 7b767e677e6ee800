package majic.gui.command;

import java.time.LocalTime;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.log.Line;

/**
 * A line of the session in the message area. Immutable.
 *
 * @param time when it arrived
 * @param line the line
 */
record Message(LocalTime time, Line line) {
    private static final DateTimeFormatter CLOCK = DateTimeFormatter.ofPattern("HH:mm:ss", Locale.ROOT);
    private static final Pattern NUMBERS =
            Pattern.compile("(\\d{1,3}(?:-\\d{1,3})?(?:,\\d{1,3}(?:-\\d{1,3})?)*)[ :.(]");
    private static final Pattern BOT = Pattern.compile("Bot (\\d{1,3}) ");

    /** Returns the numbers of the robots with which the line begins; empty if it names none there. */
    Set<Integer> robots() {
        Set<Integer> robots = new TreeSet<>();
        Matcher bot = BOT.matcher(line.text());
        Matcher numbers = NUMBERS.matcher(line.text());
        if (bot.lookingAt()) {
            robots.add(Integer.valueOf(bot.group(1)));
        } else if (numbers.lookingAt()) {
            for (String item : numbers.group(1).split(",")) {
                String[] ends = item.split("-");
                int last = Integer.parseInt(ends[ends.length - 1]);
                for (int robot = Integer.parseInt(ends[0]); robot <= last; robot++) {
                    robots.add(robot);
                }
            }
        }
        return robots;
    }

    /** Returns the text as it is shown, with a sign for its kind. */
    String text(boolean withTime) {
        return (withTime ? time.format(CLOCK) + " " : "") + sign() + line.text();
    }

    private String sign() {
        return switch (line.kind()) {
            case COMMAND -> "> ";
            case ANSWER -> "  ";
            case NOTICE -> "* ";
            case FAILURE, ERROR -> "! ";
            case ALARM -> "\u203c ";
        };
    }
}
