package majic.program;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.script.MajicParser;
import majic.script.Session;
import majic.team.Member;
import majic.team.Team;

/**
 * The robots that are added when a program starts, each by a line of MAJIC Script.
 *
 * @param ofLab robots of the simulated lab; each line states the number of its robot, so their order does not matter
 * @param requested robots that the user has requested, which get the next free numbers in this order, whether those
 *     before them can be connected or not
 */
public record FirstRobots(List<String> ofLab, List<String> requested) {
    /** How many robots connect at the same time, so that one that does not answer does not delay others. */
    private static final int AT_ONCE = Team.MAX_BOTS;

    /** Determines the robots to add to a program. */
    @FunctionalInterface
    public interface Source {
        /**
         * Returns the robots to add; may start the lab that they are in.
         *
         * @throws BotException if that cannot be started
         */
        FirstRobots firstRobots(Program program);
    }

    /** No robot. */
    public static final FirstRobots NONE = new FirstRobots(List.of(), List.of());

    /** Copies the lists. */
    public FirstRobots {
        ofLab = List.copyOf(ofLab);
        requested = List.copyOf(requested);
    }

    /**
     * Adds the robots to the team of a session: first those of the lab side by side, then the requested ones side by
     * side, which get numbers that the lab has left. Blocks until every robot is added or refused.
     *
     * @return whether every one was added
     * @throws InterruptedException if the thread is interrupted meanwhile
     */
    boolean addTo(Session session) throws InterruptedException {
        boolean labAdded = run(session, ofLab, ofLab);
        return run(session, numbered(session.team()), requested) && labAdded;
    }

    /** Returns the requested lines with numbers; without one where the line has it or the team has none left. */
    private List<String> numbered(Team team) {
        Set<Integer> taken = team.members().stream().map(Member::number).collect(Collectors.toSet());
        List<Integer> free = IntStream.rangeClosed(1, team.maxBots())
                .boxed()
                .filter(number -> !taken.contains(number))
                .toList();
        List<String> lines = new ArrayList<>();
        for (int index = 0; index < requested.size(); index++) {
            String line = requested.get(index);
            lines.add(line.contains(" as ") || index >= free.size() ? line : line + " as " + free.get(index));
        }
        return lines;
    }

    /**
     * Runs lines.
     *
     * @param robots what each line is about: lines about the same run one after the other, so that the second is
     *     refused
     */
    private static boolean run(Session session, List<String> lines, List<String> robots) throws InterruptedException {
        List<MajicParser> parsers = Stream.generate(() -> MajicParser.pipe(session))
                .limit(Math.min(AT_ONCE, lines.size()))
                .toList();
        for (int index = 0; index < lines.size(); index++) {
            parsers.get(robots.indexOf(robots.get(index)) % parsers.size()).parseText(lines.get(index));
        }
        boolean succeeded = true;
        for (MajicParser parser : parsers) {
            succeeded &= parser.awaitAll();
        }
        return succeeded;
    }
}
