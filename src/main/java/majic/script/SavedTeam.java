package majic.script;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.script.run.ScriptSource;
import majic.team.BotFactory;
import majic.team.Member;
import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;

/**
 * A team that was saved: a script of {@code add} lines, each followed by the name, the calibration and the start pose
 * of its robot. Unlike a script, opening it moves no robot, and a robot that does not answer does not prevent the
 * others from being added. Immutable.
 */
public final class SavedTeam {
    private static final String POSE = "pose";

    /** Of a wrong line, characters. */
    private static final int LONGEST_SHOWN = 200;

    private static final Pattern ADD = Pattern.compile("(?i)add\\s+(\"[^\"]+\"|\\S+)\\s+as\\s+(\\d{1,3})");
    private static final Pattern SET = Pattern.compile("(?i)(\\d{1,3})\\s+(?:set\\s+(\\w+)\\s+\\S.*|(name)\\s+(\\w+))");

    private static final Pattern PLACE = Pattern.compile("(?i)lab\\s+place\\s+(\\d{1,3})\\s+\\S.*");

    private static final Pattern MAP = Pattern.compile("(?i)map\\s+open\\s+(\"[^\"]+\"|\\S+)");

    private final List<Robot> robots;
    private final @Nullable String map;

    /**
     * One robot.
     *
     * @param settings lines that give it its name, and set its calibration and its pose
     */
    private record Robot(int number, String address, String add, List<Setting> settings) {
        /** Returns its name; empty if it has none. */
        String name() {
            return settings.stream()
                    .filter(setting -> setting.isName)
                    .map(setting -> setting.what)
                    .reduce("", (before, last) -> last);
        }
    }

    /**
     * A line behind {@code add}.
     *
     * @param isName whether it gives the robot a name
     * @param what the name, or the parameter that the line sets
     */
    private record Setting(boolean isName, String what, String line) {
        static Setting ofPlace(String line) {
            return new Setting(false, POSE, line);
        }

        static Setting of(Matcher set) {
            boolean isName = set.group(3) != null;
            return new Setting(isName, isName ? set.group(4) : set.group(2), set.group());
        }
    }

    private SavedTeam(List<Robot> robots, @Nullable String map) {
        this.robots = List.copyOf(robots);
        this.map = map;
    }

    /**
     * Reads a file. Blocks.
     *
     * @param file what {@code save team} has written
     * @return the team
     * @throws BotException if the file cannot be read or has other lines in it; the message names the first
     */
    public static SavedTeam read(Path file) {
        SavedTeam team = parse(ScriptSource.textOf(file), file.getFileName() + ":");
        if (team.isEmpty()) {
            throw new BotException(file + ": there is no robot in this team");
        }
        return team;
    }

    /**
     * Reads a text.
     *
     * @param script what {@link Session#teamScript()} has returned
     * @return the team, which may be empty
     * @throws BotException if there are other lines in it; the message names the first
     */
    public static SavedTeam parse(String script) {
        return parse(script, "line ");
    }

    private static SavedTeam parse(String script, String place) {
        List<Robot> robots = new ArrayList<>();
        String map = null;
        List<String> lines = script.lines().toList();
        for (int index = 0; index < lines.size(); index++) {
            String line = lines.get(index).strip();
            if (MAP.matcher(line).matches()) {
                map = line;
            } else if (!line.isEmpty() && !line.startsWith("#") && !isTaken(line, robots)) {
                throw new BotException(place + (index + 1) + ": \"" + VisibleText.of(shortened(line))
                        + "\" is no line of a saved team; it has \"map open FILE\", \"add ADDRESS as N\" and then \"N name NAME\","
                        + " \"N set P VALUE\" and \"lab place N X Y HEADING\"");
            }
        }
        return new SavedTeam(robots, map);
    }

    private static String shortened(String line) {
        return line.length() > LONGEST_SHOWN ? line.substring(0, LONGEST_SHOWN) + "..." : line;
    }

    private static boolean isTaken(String line, List<Robot> robots) {
        Matcher add = ADD.matcher(line);
        Matcher set = SET.matcher(line);
        if (add.matches()) {
            String address = add.group(1).replace("\"", "");
            robots.add(new Robot(Integer.parseInt(add.group(2)), address, line, new ArrayList<>()));
            return true;
        }
        Matcher place = PLACE.matcher(line);
        if (place.matches()) {
            return isAdded(robots, place.group(1), Setting.ofPlace(line));
        }
        return set.matches() && isAdded(robots, set.group(1), Setting.of(set));
    }

    private static boolean isAdded(List<Robot> robots, String number, Setting setting) {
        return robots.stream()
                .filter(robot -> robot.number == Integer.parseInt(number))
                .anyMatch(robot -> robot.settings.add(setting));
    }

    /**
     * Returns whether there is no robot in it.
     *
     * @return true for a text without {@code add}
     */
    public boolean isEmpty() {
        return robots.isEmpty();
    }

    /**
     * Returns whether a robot of the simulated lab is in it.
     *
     * @return true if the lab must run before it is opened
     */
    public boolean needsLab() {
        return robots.stream()
                .anyMatch(robot -> robot.address.toLowerCase(Locale.ROOT).startsWith(BotAddress.SIMULATED + ":"));
    }

    /**
     * Names the robots for users.
     *
     * @param factory has the names of the types
     * @return for instance {@code 1 Pioneer}, {@code 2 Rex (Aibo)}
     */
    public List<String> names(BotFactory factory) {
        return robots.stream()
                .map(robot -> robot.number + " " + Member.label(robot.name(), label(robot.address, factory)))
                .toList();
    }

    private static String label(String text, BotFactory factory) {
        try {
            BotAddress address = BotAddress.parse(text);
            String type = address.scheme().equals(BotAddress.SIMULATED)
                    ? address.rest().replaceFirst("\\d+$", "")
                    : address.type();
            return factory.types().stream()
                    .filter(known -> known.isMeantBy(type))
                    .map(BotType::label)
                    .findFirst()
                    .orElse(type);
        } catch (BotException e) {
            return text;
        }
    }

    /**
     * Opens the map of the team, adds the robots, all at the same time, and sets their calibrations and poses. Returns
     * at once; the answers go to the listeners of the session.
     *
     * @param session the session to add them to
     */
    public void open(Session session) {
        if (map != null) {
            MajicParser.pipe(session).parseText(map);
        }
        for (Robot robot : robots) {
            session.team()
                    .time()
                    .thread("opening robot " + robot.number, () -> open(robot, session))
                    .start();
        }
    }

    private static void open(Robot robot, Session session) {
        MajicParser parser = MajicParser.pipe(session);
        try {
            parser.parseText(robot.add);
            if (parser.awaitAll()) {
                Predicate<Setting> belongs = belongsTo(session.team().member(robot.number));
                robot.settings.stream().filter(belongs).map(Setting::line).forEach(parser::parseText);
                robot.settings.stream()
                        .filter(belongs.negate())
                        .forEach(setting -> session.alarm(setting.line + ": a saved team sets calibrations and \"pose\""
                                + " only; type the line to run it"));
            }
        } catch (BotException e) {
            session.alarm(String.valueOf(e.getMessage()));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static Predicate<Setting> belongsTo(Member member) {
        List<String> names = member.bot().calibration();
        return setting -> setting.isName
                || setting.what.equalsIgnoreCase(POSE)
                || names.stream().anyMatch(name -> name.equalsIgnoreCase(setting.what));
    }
}
