package majic.script.lines;

import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import majic.bot.BotCommand;
import majic.script.commands.LineParser;
import majic.script.commands.ScriptParser;
import majic.script.commands.SessionParser;
import majic.team.Member;
import majic.team.Team;

/** Completes lines that begin with a robot's command and name no robots. Thread-safe. */
public final class DefaultRobots {
    private final Team team;
    private volatile Supplier<List<Integer>> numbers = List::of;

    public DefaultRobots(Team team) {
        this.team = team;
    }

    /** Sets the robots that are meant by lines without robots. */
    public void use(Supplier<List<Integer>> robots) {
        numbers = robots;
    }

    /** Returns the robots that are meant by lines without robots and are in the team. */
    public List<Member> members() {
        List<Integer> robots = numbers.get();
        return team.members().stream()
                .filter(member -> robots.contains(member.number()))
                .toList();
    }

    /**
     * Puts the numbers of the robots in front of a line that begins with one of their commands.
     *
     * @return {@code 1,3 move 500} for {@code move 500}; the same line if it is for the session, begins a block, names
     *     robots, or cannot be understood
     */
    public String addTo(String line) {
        List<Integer> robots = numbers.get();
        if (robots.isEmpty() || line.length() > LineParser.LONGEST_LINE) {
            return line;
        }
        LineParser parser = new LineParser(line, List.of());
        if (parser.firstWord().filter(word -> isCommandOf(robots, word)).isEmpty()) {
            return line;
        }
        String names = robots.stream().map(String::valueOf).collect(Collectors.joining(","));
        return names + (parser.isCallWithoutRobots() ? "." : " ") + line.stripLeading();
    }

    private boolean isCommandOf(List<Integer> robots, String word) {
        if (SessionParser.WORDS.contains(word) || ScriptParser.BLOCK_WORDS.contains(word)) {
            return false;
        }
        return LineParser.COMMAND_WORDS.contains(word)
                || team.members().stream()
                        .filter(member -> robots.contains(member.number()))
                        .anyMatch(member -> hasCommand(member, word));
    }

    private static boolean hasCommand(Member member, String word) {
        return member.bot().commands().stream().map(BotCommand::name).anyMatch(word::equalsIgnoreCase);
    }
}
