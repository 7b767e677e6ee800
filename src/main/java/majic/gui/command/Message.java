package majic.gui.command;

import java.time.LocalTime;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.log.Line;
import majic.text.NumberList;
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
    private static final Pattern LATCH = Pattern.compile("STOP.* is latched; .*");
    private static final Pattern STOP = Pattern.compile("\\d{1,4} stop: ");
    private static final Pattern CONFIRMATION = Pattern.compile("\\d{1,4} stop: done");
    private static final Pattern OVERDUE = Pattern.compile("\\d{1,4}: .* has not confirmed its stop within ");
    private static final DateTimeFormatter CLOCK = DateTimeFormatter.ofPattern("HH:mm:ss", Locale.ROOT);
    private static final Pattern NUMBERS =
            Pattern.compile("(\\d{1,3}(?:-\\d{1,3})?(?:,\\d{1,3}(?:-\\d{1,3})?)*)[ :.(]");
    private static final Pattern BOT = Pattern.compile("Bot (\\d{1,3}) ");

    /** Creates the message of a line that has arrived once. */
    Message(LocalTime time, Line line) {
        this(time, line, 1);
    }

    /** What a message is to a STOP. */
    enum Part {
        /** The report that STOP is latched. */
        LATCH,
        /** A robot has confirmed its stop. */
        CONFIRMATION,
        /** A robot has not confirmed its stop, or is not free after it. */
        FAILURE,
        /** The alarm about a robot that has not confirmed its stop in time. */
        OVERDUE,
        /** A command, or the report of a release: a STOP behind it is another one. */
        END,
        /** Anything else. */
        NONE
    }

    /** Returns what it is to a STOP. */
    Part part() {
        String text = line.text();
        return switch (line.kind()) {
            case COMMAND -> Part.END;
            case NOTICE ->
                text.startsWith("released: ") ? Part.END : LATCH.matcher(text).matches() ? Part.LATCH : Part.NONE;
            case ANSWER -> CONFIRMATION.matcher(text).matches() ? Part.CONFIRMATION : Part.NONE;
            case FAILURE -> STOP.matcher(text).lookingAt() ? Part.FAILURE : Part.NONE;
            case ALARM ->
                STOP.matcher(text).lookingAt()
                        ? Part.FAILURE
                        : OVERDUE.matcher(text).lookingAt() ? Part.OVERDUE : Part.NONE;
            case ERROR -> Part.NONE;
        };
    }

    /** Returns whether an answer of one robot differs from this message at most in the robot. */
    boolean hasAnswerOf(Message other) {
        return line.kind() == other.line.kind() && answer().equals(other.answer());
    }

    private String answer() {
        return line.text().substring(line.text().indexOf(' '));
    }

    /** Returns the same answer of several robots, in increasing order. */
    Message ofRobots(Set<Integer> robots) {
        String list = NumberList.of(List.copyOf(robots)).replace(", ", ",").replace('\u2013', '-');
        return new Message(time, new Line(line.kind(), list + answer(), line.asker()), count);
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
