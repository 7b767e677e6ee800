package majic.soak;

import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;

/** Draws the lines of one source from a seed: the same seed gives the same lines. Used by one thread. */
final class CommandScript {
    private static final List<String> READINGS = List.of("x", "speed", "heading", "moving", "battery", "age");
    private static final List<String> CONDITIONS =
            List.of("distanceFront < 150", "x > 200", "any battery < 1", "2 x > 100", "3 moving == yes");

    private final Random random;
    private final List<String> robots;
    private final int removable;
    private int next;
    private final int step;

    /**
     * Creates the script of one of several sources.
     *
     * @param robots the names of the lab's robots, in the order of their numbers
     * @param source from 0; the lines of different sources have different numbers
     * @param sources how many there are
     */
    CommandScript(long seed, List<String> robots, int source, int sources) {
        this.random = new Random(seed * 31 + source);
        this.robots = robots;
        this.removable = robots.size();
        this.next = source;
        this.step = sources;
    }

    /** Returns how long the source pauses before its next line: mostly not at all. */
    double pauseSeconds() {
        return random.nextInt(4) == 0 ? random.nextInt(600) / 1000.0 : 0;
    }

    SentLine next() {
        next += step;
        int kind = random.nextInt(100);
        if (kind < 30) {
            return tagged("move " + (random.nextInt(60) - 20));
        } else if (kind < 42) {
            return tagged("turn " + (random.nextInt(60) - 30));
        } else if (kind < 50) {
            return tagged("drive " + (random.nextInt(100) - 50), " " + random.nextInt(20) + " for 0.3s");
        } else if (kind < 58) {
            return tagged("move " + random.nextInt(200), " until " + drawn(CONDITIONS));
        } else if (kind < 66) {
            return tagged("set pose " + random.nextInt(100), " 0 0");
        } else if (kind < 86) {
            return untagged(robot(), "get " + (random.nextBoolean() ? "now " : "") + drawn(READINGS));
        }
        return seldom(kind);
    }

    private SentLine seldom(int kind) {
        if (kind < 88) {
            return tagged("act Soak times=" + random.nextInt(3), "");
        } else if (kind < 89) {
            return untagged(robot(), "act off");
        } else if (kind < 91) {
            return untagged(1 + random.nextInt(removable - 1), "stop");
        } else if (kind < 92) {
            return random.nextInt(4) == 0
                    ? new SentLine(next, "stop", all(), "stop")
                    : new SentLine(next, "release", Set.of(), "release");
        } else if (kind < 94) {
            return new SentLine(next, "release", Set.of(), "release");
        } else if (kind < 95) {
            return new SentLine(next, "wait 0.2s", Set.of(), "wait");
        } else if (kind < 97) {
            return connecting();
        }
        return tagged(drawn(List.of("mvoe 1", "set noSuchThing 1", "move 1m ", "turn 99999")));
    }

    private SentLine connecting() {
        if (random.nextInt(4) == 0) {
            return new SentLine(next, "remove " + removable, Set.of(), "remove");
        }
        int robot = random.nextInt(3) == 0 ? removable : robot();
        return add(robot);
    }

    /** A line that connects a robot, as a new one or again. */
    SentLine adding(int robot) {
        next += step;
        return add(robot);
    }

    private SentLine add(int robot) {
        return new SentLine(next, "add sim:" + robots.get(robot - 1) + " as " + robot, Set.of(), "add");
    }

    SentLine release() {
        next += step;
        return new SentLine(next, "release", Set.of(), "release");
    }

    /** A line that sets a pose, so that it moves nothing, with a number of its own. */
    SentLine check(int robot) {
        next += step;
        return tagged(Set.of(robot), Integer.toString(robot), "set pose 0", " 0 0");
    }

    private SentLine tagged(String start) {
        return tagged(start, "");
    }

    /** For one robot mostly, sometimes for two, sometimes for all. */
    private SentLine tagged(String start, String rest) {
        int how = random.nextInt(12);
        if (how == 0) {
            return tagged(all(), "all", start, rest);
        } else if (how == 1) {
            int second = 2 + random.nextInt(robots.size() - 2);
            return tagged(Set.of(1, second), "1," + second, start, rest);
        }
        int robot = robot();
        return tagged(Set.of(robot), Integer.toString(robot), start, rest);
    }

    private SentLine tagged(Set<Integer> who, String words, String start, String rest) {
        return new SentLine(next, String.format(Locale.ROOT, "%s %s.%08d%s", words, start, next, rest), who, "");
    }

    private SentLine untagged(int robot, String command) {
        return new SentLine(next, robot + " " + command, Set.of(robot), command.replace("get now", "get"));
    }

    private int robot() {
        return 1 + random.nextInt(robots.size());
    }

    private Set<Integer> all() {
        Set<Integer> all = new TreeSet<>();
        for (int robot = 1; robot <= robots.size(); robot++) {
            all.add(robot);
        }
        return all;
    }

    private String drawn(List<String> from) {
        return from.get(random.nextInt(from.size()));
    }
}
