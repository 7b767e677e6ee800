package majic.soak;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Compares the lines that were sent with a session log: every command to a robot must have ended exactly once. A line
 * ends as a whole if it is refused or dropped; otherwise each of its robots answers it.
 */
final class Account {
    private static final Pattern LOGGED = Pattern.compile("\\S+ \\S+ (\\w+) +(.*)");
    private static final Pattern REFUSAL = Pattern.compile("line (\\d+): .*");
    private static final Pattern TAG = Pattern.compile("\\d\\.(\\d{8})(?!\\d)");
    private static final Pattern ROBOT = Pattern.compile("(\\d+) .*");

    private final Map<Integer, SentLine> sent = new HashMap<>();
    private final Map<Integer, Ends> ends = new HashMap<>();
    private final Map<String, Integer> expected = new TreeMap<>();
    private final Map<String, Integer> found = new TreeMap<>();
    private final Map<Outcome, Long> outcomes = new EnumMap<>(Outcome.class);
    private final List<String> problems = new ArrayList<>();
    private final int removable;
    private long commandLines;

    /** How a tagged line ended: once as a whole, or once for each robot. */
    private static final class Ends {
        private final List<Outcome> whole = new ArrayList<>();
        private final Map<Integer, List<Outcome>> robots = new TreeMap<>();
    }

    /**
     * Creates an account of lines.
     *
     * @param removable the robot that may be missing in the team when a line for all robots comes
     */
    Account(List<SentLine> lines, int removable) {
        this.removable = removable;
        lines.forEach(line -> sent.put(line.number(), line));
        lines.stream().filter(line -> !line.isTagged()).forEach(line -> expect(line, 1));
    }

    private void expect(SentLine line, int count) {
        line.robots().forEach(robot -> expected.merge(robot + " " + line.untagged(), count, Integer::sum));
    }

    /** Reads a log and compares. */
    Account read(Path log) {
        try (Stream<String> lines = Files.lines(log)) {
            lines.forEach(this::readLine);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        if (commandLines != sent.size()) {
            problems.add(sent.size() + " lines were sent, the log has " + commandLines);
        }
        sent.values().stream().filter(SentLine::isTagged).forEach(this::settle);
        expected.forEach(this::settleUntagged);
        return this;
    }

    /** Returns each command without exactly one outcome, as a sentence. */
    List<String> problems() {
        return problems;
    }

    /** Returns the number of commands to a robot by outcome. */
    Map<Outcome, Long> outcomes() {
        return outcomes;
    }

    private void readLine(String logged) {
        Matcher parts = LOGGED.matcher(logged);
        if (!parts.matches()) {
            problems.add("no line of a log: " + logged);
        } else if (parts.group(1).equals("command")) {
            commandLines++;
        } else if (!parts.group(1).equals("notice")) {
            readEnd(parts.group(1), parts.group(2));
        } else if (parts.group(2).contains("missing here")) {
            problems.add(parts.group(2));
        }
    }

    private void readEnd(String kind, String text) {
        Matcher refusal = REFUSAL.matcher(text);
        if (kind.equals("error") && refusal.matches()) {
            refuse(Integer.parseInt(refusal.group(1)), text);
            return;
        }
        int reading = text.indexOf(" = ");
        int colon = text.indexOf(": ");
        if (reading > 0 && (colon < 0 || reading < colon)) {
            foundReading(text.substring(0, reading));
        } else if (colon > 0) {
            ended(text.substring(0, colon), Outcome.of(kind, text.substring(colon + 2)), text);
        }
    }

    private void refuse(int number, String text) {
        SentLine line = sent.get(number);
        if (line == null) {
            problems.add("a line that was not sent was refused: " + text);
        } else if (line.isTagged()) {
            ends(number).whole.add(Outcome.REFUSED);
        } else {
            expect(line, -1);
            count(Outcome.REFUSED, line.robots().size());
        }
    }

    private void foundReading(String robotAndParameter) {
        found(robotAndParameter.replaceFirst(" ", " get "), Outcome.DONE);
    }

    private void ended(String head, Outcome how, String text) {
        Matcher tag = TAG.matcher(head);
        Matcher robot = ROBOT.matcher(head);
        if (!tag.find()) {
            found(head.replace("get now ", "get "), how);
            return;
        }
        int number = Integer.parseInt(tag.group(1));
        if (!sent.containsKey(number)) {
            problems.add("an answer to nothing: " + text);
        } else if (robot.matches()) {
            ends(number)
                    .robots
                    .computeIfAbsent(Integer.parseInt(robot.group(1)), key -> new ArrayList<>())
                    .add(how);
        } else {
            ends(number).whole.add(how);
        }
    }

    private void found(String command, Outcome how) {
        if (expected.containsKey(command)) {
            found.merge(command, 1, Integer::sum);
            count(how, 1);
        }
    }

    private Ends ends(int number) {
        return ends.computeIfAbsent(number, key -> new Ends());
    }

    private void count(Outcome how, long times) {
        outcomes.merge(how, times, Long::sum);
    }

    private void settle(SentLine line) {
        Ends its = ends(line.number());
        if (its.whole.size() > 1) {
            problems.add("\"" + line.text() + "\" ended as a whole " + its.whole);
        }
        for (int robot : line.robots()) {
            settle(line, robot, its);
        }
    }

    private void settle(SentLine line, int robot, Ends its) {
        List<Outcome> outcomes =
                its.robots.getOrDefault(robot, its.whole.stream().limit(1).toList());
        outcomes.stream().limit(1).forEach(how -> count(how, 1));
        boolean mayBeMissing = robot == removable && line.robots().size() > 1;
        if (outcomes.size() > 1 || (outcomes.isEmpty() && !mayBeMissing)) {
            problems.add("\"" + line.text() + "\" ended on robot " + robot + " as " + outcomes);
        }
    }

    private void settleUntagged(String command, int count) {
        int ended = found.getOrDefault(command, 0);
        boolean mayBeMissing = command.equals(removable + " stop");
        if (ended > count || (ended < count && !mayBeMissing)) {
            problems.add("\"" + command + "\" was sent " + count + " times and ended " + ended + " times");
        }
    }
}
