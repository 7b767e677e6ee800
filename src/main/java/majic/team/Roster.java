package majic.team;

import java.util.HashSet;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import majic.bot.BotException;

/** The robots of a team by number, their names, and the number of the next one. Thread-safe. */
final class Roster {
    private static final int LONGEST_NAME = 20;
    private static final String NAME = "\\p{L}[\\p{L}\\d_]{0," + (LONGEST_NAME - 1) + "}";

    private final int maxBots;
    private final SortedMap<Integer, Member> members = new TreeMap<>();
    private final Set<Integer> usedNumbers = new HashSet<>();

    Roster(int maxBots) {
        this.maxBots = maxBots;
    }

    int maxBots() {
        return maxBots;
    }

    /**
     * Adds a robot.
     *
     * @param wanted its number; empty for the lowest that was never used
     * @param making creates the member with that number; the roster is locked meanwhile
     * @throws BotException if the number is taken or out of range, or there is no room
     */
    synchronized Member add(OptionalInt wanted, IntFunction<Member> making) {
        int number = number(wanted);
        usedNumbers.add(number);
        Member member = making.apply(number);
        members.put(number, member);
        return member;
    }

    /**
     * Returns the number that a new robot would get.
     *
     * @throws BotException as {@link #add}
     */
    synchronized int number(OptionalInt wanted) {
        return wanted.isPresent() ? checkFree(wanted.getAsInt()) : lowestFree();
    }

    private int checkFree(int number) {
        if (number < 1 || number > maxBots) {
            throw new BotException(number + ": robots have numbers from 1 to " + maxBots);
        }
        if (members.containsKey(number)) {
            throw new BotException(number + ": there is a robot " + number + " already");
        }
        return number;
    }

    private int lowestFree() {
        for (int number = 1; number <= maxBots; number++) {
            if (!usedNumbers.contains(number)) {
                return number;
            }
        }
        throw new BotException(
                members.size() < maxBots
                        ? "all numbers up to " + maxBots
                                + " were used; add the robot \"as\" the number of a removed one"
                        : "the team is full (" + maxBots
                                + " robots); remove one first, or start MAJIC with a higher --max-robots");
    }

    /**
     * Names a robot.
     *
     * @param name one word; empty for none
     * @throws BotException if it cannot be a name, or another robot has it; nothing has changed
     */
    synchronized void rename(Member member, String name) {
        if (!name.isEmpty() && !name.matches(NAME)) {
            throw new BotException(name + ": a name is a letter, then letters, digits and _, at most " + LONGEST_NAME
                    + " characters in all");
        }
        for (Member other : members.values()) {
            if (other != member && !name.isEmpty() && other.name().equalsIgnoreCase(name)) {
                throw new BotException(name + ": robot " + other.number() + " has this name already");
            }
        }
        member.rename(name);
    }

    /** Removes a robot; false if it was removed already. */
    synchronized boolean remove(Member member) {
        return members.remove(member.number(), member);
    }

    synchronized void clear() {
        members.clear();
    }

    /**
     * Returns a robot by its number.
     *
     * @throws BotException if there is none; the message lists those there are
     */
    synchronized Member member(int number) {
        Member member = members.get(number);
        if (member == null) {
            throw new BotException(number + ": there is no robot " + number + " (" + words(all()) + ")");
        }
        return member;
    }

    /** A snapshot, by number. */
    synchronized List<Member> all() {
        return List.copyOf(members.values());
    }

    /** Lists robots, for instance {@code robots: 1 Rex (Aibo), 2 Pioneer}. */
    static String words(List<Member> robots) {
        return robots.isEmpty()
                ? "no robots yet; add one"
                : robots.stream()
                        .map(member -> member.number() + " " + member.label())
                        .collect(Collectors.joining(", ", "robots: ", ""));
    }
}
