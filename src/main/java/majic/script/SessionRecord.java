package majic.script;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import majic.bot.Answer;
import majic.bot.BotException;
import majic.bot.Member;
import majic.bot.Team;
import majic.bot.TeamListener;

/**
 * What was done in a session, as a script that does it again: with the pauses between the lines, and waits where one
 * robot was started after another had finished. Thread-safe.
 */
final class SessionRecord {
    private static final double SHORTEST_PAUSE_S = 0.1;

    private final Team team;
    private final List<String> lines = new ArrayList<>();
    private final Map<Integer, Long> lastAnswerNanos = new LinkedHashMap<>();
    private final Set<Integer> started = new TreeSet<>();
    private long lastNanos;

    SessionRecord(Team team) {
        this.team = team;
        team.addListener(new TeamListener() {
            @Override
            public void answered(Answer answer) {
                finished(answer.robot());
            }
        });
    }

    private synchronized void finished(int robot) {
        lastAnswerNanos.put(robot, team.time().nanos());
    }

    synchronized void added(String address, int number) {
        lines.add("add " + quoted(address) + " as " + number);
        lastNanos = team.time().nanos();
    }

    synchronized void removed(int number) {
        lines.add("remove " + number);
        started.remove(number);
        lastNanos = team.time().nanos();
    }

    /**
     * A line about to be carried out, with what has to go before it.
     *
     * @param line empty if a replay can do without it
     * @param robots those it makes do something
     * @param finished the others that had finished by then, and when
     * @param atNanos when it began
     */
    record Entry(String line, Set<Integer> robots, Map<Integer, Long> finished, long atNanos) {}

    /** Looks at what had finished when a line began; nothing is kept before {@link #commit}. */
    synchronized Entry prepare(Given given, Selection selection, boolean typed) {
        Set<Integer> robots = Given.robots(given.statement(), selection);
        Map<Integer, Long> finished = robots.isEmpty() ? Map.of() : finishedOthers(robots);
        return new Entry(
                given.forRecord(team, typed), robots, finished, team.time().nanos());
    }

    /** Keeps a line. */
    synchronized void commit(Entry entry) {
        if (entry.line.isEmpty()) {
            return;
        }
        if (!entry.finished.isEmpty()) {
            lines.add(entry.finished.keySet().stream().map(String::valueOf).collect(Collectors.joining(",")) + " wait");
            entry.finished.values().forEach(atNanos -> lastNanos = Math.max(lastNanos, atNanos));
            started.removeAll(entry.finished.keySet());
        }
        pause((entry.atNanos - lastNanos) / 1e9);
        lines.addAll(entry.line.lines().toList());
        started.addAll(entry.robots);
        lastNanos = entry.atNanos;
    }

    /** A line is over; what takes its time in a replay as well is not to be paused for once more. */
    synchronized void took(Given given, boolean typed) {
        if (given.isWait() || (!typed && !given.isQuick())) {
            lastNanos = team.time().nanos();
        }
    }

    private Map<Integer, Long> finishedOthers(Set<Integer> robots) {
        Map<Integer, Long> finished = new TreeMap<>();
        for (int number : started) {
            if (!robots.contains(number) && isIdle(number)) {
                finished.put(number, lastAnswerNanos.getOrDefault(number, lastNanos));
            }
        }
        return finished;
    }

    private boolean isIdle(int number) {
        try {
            Member member = team.member(number);
            return member.isIdle();
        } catch (BotException e) {
            return false;
        }
    }

    private void pause(double seconds) {
        boolean first = lines.stream().allMatch(line -> line.startsWith("add "));
        if (!first && seconds >= SHORTEST_PAUSE_S) {
            lines.add(String.format(Locale.ROOT, "wait %.1fs", seconds));
        }
    }

    /** Everything so far. */
    synchronized List<String> lines() {
        return List.copyOf(lines);
    }

    void save(Path file) throws IOException {
        List<String> all = new ArrayList<>();
        all.add("# A session of MAJIC; \"run FILE\" does it again.");
        all.addAll(lines());
        Files.write(file, all);
    }

    /** An address or a file as a script would write it. */
    static String quoted(String value) {
        return value.matches("[^\\s#\"]+") ? value : '"' + value + '"';
    }
}
