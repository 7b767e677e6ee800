package majic.ros.graph;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * The table of known robots: MAJIC's own, {@code robots.txt} beside this class, and before it the user's. Immutable.
 *
 * <p>A table is text. A line {@code robot NAME} begins an entry, the lines below it state its properties; {@code #}
 * begins a comment. The first entry with a sign that is seen is the robot. docs/robots/ros.md describes the properties.
 */
public final class KnownRobots {
    /** A robot that is not in the table: careful limits, and nothing that could be wrong. */
    public static final KnownRobot UNKNOWN = new RobotEntry("unknown robot").robot();

    private static final int LONGEST_LINE = 500;
    private static final Pattern INVISIBLE = Pattern.compile("\\p{C}");

    private final List<Entry> entries;

    private record Entry(KnownRobot robot, List<RobotSign> signs) {}

    private KnownRobots(List<Entry> entries) {
        this.entries = List.copyOf(entries);
    }

    /**
     * Returns MAJIC's own table, which is read once.
     *
     * @return the table
     */
    public static KnownRobots builtIn() {
        return BuiltIn.TABLE;
    }

    /** Reads the table when it is used first. */
    private static final class BuiltIn {
        private static final KnownRobots TABLE = readBuiltIn();
    }

    private static KnownRobots readBuiltIn() {
        try (InputStream file = KnownRobots.class.getResourceAsStream("robots.txt")) {
            if (file == null) {
                throw new IllegalStateException("robots.txt is missing beside " + KnownRobots.class);
            }
            String text = new String(file.readAllBytes(), StandardCharsets.UTF_8);
            return new KnownRobots(List.of()).with("robots.txt", text);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Adds entries in front of these.
     *
     * @param name of the file, for messages
     * @param text its content
     * @return a new table
     * @throws IllegalArgumentException if a line is wrong; the message names file and line, and says what would be
     *     right
     */
    public KnownRobots with(String name, String text) {
        List<Entry> all = new ArrayList<>();
        RobotEntry open = null;
        int line = 0;
        for (String each : text.lines().toList()) {
            line++;
            String content = each.replaceFirst("(^|\\s)#.*", "").strip();
            if (!content.isEmpty()) {
                try {
                    open = read(content, open, all);
                } catch (IllegalArgumentException e) {
                    throw new IllegalArgumentException(name + " line " + line + ": " + e.getMessage(), e);
                }
            }
        }
        end(open, all);
        all.addAll(entries);
        return new KnownRobots(all);
    }

    /** Reads one line; returns the entry that the next line belongs to. */
    private RobotEntry read(String content, @Nullable RobotEntry open, List<Entry> done) {
        if (content.length() > LONGEST_LINE) {
            throw new IllegalArgumentException("the line is longer than " + LONGEST_LINE + " characters");
        }
        List<String> words = List.of(content.split("\\s+"));
        String key = words.get(0);
        List<String> rest = words.subList(1, words.size());
        if (key.equals("robot")) {
            end(open, done);
            return new RobotEntry(checkedName(String.join(" ", rest)));
        }
        if (open == null) {
            throw new IllegalArgumentException("an entry begins with \"robot NAME\"");
        }
        if (key.equals("like")) {
            open.like(find(String.join(" ", rest), done));
        } else {
            open.set(key, rest);
        }
        return open;
    }

    /** Returns a name by which a robot can be found. */
    private static String checkedName(String name) {
        if (word(name).isEmpty() || INVISIBLE.matcher(name).find()) {
            throw new IllegalArgumentException(
                    "behind \"robot\" a name is missing; it has letters or digits, and no invisible characters");
        }
        return name;
    }

    private static void end(@Nullable RobotEntry open, List<Entry> done) {
        if (open != null) {
            done.add(new Entry(open.robot(), open.signs()));
        }
    }

    private KnownRobot find(String name, List<Entry> sooner) {
        return named(name, sooner)
                .or(() -> named(name, entries))
                .orElseThrow(() -> new IllegalArgumentException("there is no robot " + name + " above"));
    }

    private static Optional<KnownRobot> named(String name, List<Entry> entries) {
        return entries.stream()
                .map(Entry::robot)
                .filter(robot -> word(robot.name()).equals(word(name)))
                .findFirst();
    }

    private static String word(String name) {
        return name.toLowerCase(Locale.ROOT).replaceAll("[^\\p{L}\\p{N}]", "");
    }

    /**
     * Finds an entry by its name.
     *
     * @param name case, spaces and punctuation are ignored
     * @return the entry, if there is one
     */
    public Optional<KnownRobot> named(String name) {
        return named(name, entries);
    }

    /**
     * Returns the names of all entries.
     *
     * @return in the order of the table
     */
    public List<String> names() {
        return entries.stream().map(entry -> entry.robot().name()).toList();
    }

    /**
     * Recognises a robot. May call services of the robot, so it blocks.
     *
     * @param evidence what is there
     * @return the first entry with a sign that is seen; {@link #UNKNOWN} if there is none
     */
    public KnownRobot recognise(RobotEvidence evidence) {
        return entries.stream()
                .filter(entry -> entry.signs().stream().anyMatch(sign -> sign.isSeenIn(evidence)))
                .map(Entry::robot)
                .findFirst()
                .orElse(UNKNOWN);
    }

    /**
     * Prefers the topics of a robot's entry to those that were found by their names.
     *
     * @param robot the entry
     * @param base as found
     * @param graph the topics
     * @return the base with the first topics of the entry that are there
     */
    public static Base withTopics(KnownRobot robot, Base base, RosGraph graph) {
        String command = first(robot.commands(), base, graph).orElse(base.command());
        String type = graph.typeOf(command);
        Optional<String> odometry = first(robot.odometry(), base, graph);
        return new Base(
                base.namespace(),
                command,
                type == null ? base.commandType() : type,
                odometry.isPresent() ? odometry.get() : base.odometry());
    }

    private static Optional<String> first(List<String> relative, Base base, RosGraph graph) {
        return relative.stream()
                .map(topic -> base.namespace() + "/" + topic)
                .filter(graph.topics()::containsKey)
                .findFirst();
    }
}
