package majic.gui.command;

import java.time.LocalTime;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.log.Line;
import majic.text.Texts;

/**
 * A line of the session in the message area. Immutable.
 *
 * @param time when it arrived; of a repeated line, when it arrived last
 * @param line the line
 * @param count how often it has arrived
 */
record Message(LocalTime time, Line line, int count) {
    private static final Texts TEXTS = Texts.of(Message.class);
    private static final Pattern OF_STOP = Pattern.compile("\\d{1,4} stop: .*|STOP.* is latched; .*");
    private static final DateTimeFormatter CLOCK = DateTimeFormatter.ofPattern("HH:mm:ss", Locale.ROOT);
    private static final Pattern NUMBERS =
            Pattern.compile("(\\d{1,3}(?:-\\d{1,3})?(?:,\\d{1,3}(?:-\\d{1,3})?)*)[ :.(]");
    private static final Pattern BOT = Pattern.compile("Bot (\\d{1,3}) ");

    /** Creates the message of a line that has arrived once. */
    Message(LocalTime time, Line line) {
        this(time, line, 1);
    }

    /** Returns whether it answers a stop or reports the latch, so that a further press of STOP repeats it. */
    boolean isOfStop() {
        return line.kind() != Line.Kind.COMMAND && OF_STOP.matcher(line.text()).matches();
    }

    /** Returns whether another message is the same line again. */
    boolean isRepeatedBy(Message other) {
        return line.kind() == other.line.kind() && line.text().equals(other.line.text());
    }

    /** Returns this message with one more that repeats it. */
    Message and(Message repetition) {
        return new Message(repetition.time, line, count + 1);
    }

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
        String times = count == 1 ? "" : " " + TEXTS.get("repeated", count);
        return (withTime ? time.format(CLOCK) + " " : "") + sign() + line.text() + times;
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
