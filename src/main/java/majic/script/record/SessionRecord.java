package majic.script.record;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import majic.file.WholeFile;
import majic.team.Answer;
import majic.team.ManualCommand;
import majic.team.Member;
import majic.team.Owner;
import majic.team.Team;
import majic.team.TeamListener;
import org.jspecify.annotations.Nullable;

/**
 * Collects what is done in a session, with its times, so that a script can do it again: commands, and what reaches the
 * robots without a command, as stops by button or key and manual control. The team reports these after they were sent,
 * so recording delays none of them. Thread-safe.
 */
public final class SessionRecord {
    /** Several hours of a program that sends ten commands a second; about 50 MB. */
    private static final int MOST_EVENTS = 200_000;

    private final Team team;
    private final int mostEvents;
    private final List<Event> events = new ArrayList<>();
    private final Map<Integer, Long> lastAnswerNanos = new HashMap<>();

    /** For each robot under manual control, the others that had finished before, and when. */
    private final Map<Integer, Map<Integer, Long>> finishedBeforeManual = new HashMap<>();

    private final Set<Integer> started = new TreeSet<>();
    private long leftOut;

    public SessionRecord(Team team) {
        this(team, MOST_EVENTS);
    }

    SessionRecord(Team team, int mostEvents) {
        this.team = team;
        this.mostEvents = mostEvents;
        team.addListener(new TeamRecorder());
    }

    /** The time on the clock of the team, nanoseconds. */
    public long nanos() {
        return team.time().nanos();
    }

    /** Keeps that a robot joined. */
    public synchronized void added(String address, int number) {
        String line = "add " + quoted(address) + " as " + number;
        keep(new Event(Event.Kind.ADD, nanos(), line, Set.of(number), Set.of(), Map.of(), null));
    }

    /** Keeps that a robot was removed at a time, and stopped by that if it was busy. */
    public synchronized void removed(int number, boolean wasBusy, long atNanos) {
        if (wasBusy) {
            stopped(Set.of(number), atNanos, null);
        }
        keep(event(Event.Kind.COMMAND, atNanos, "remove " + number, Set.of(number), null));
        started.remove(number);
    }

    /**
     * Creates the entry for a command that is about to run; nothing is kept before {@link #keep}.
     *
     * @param text the line that does it again
     * @param members the robots that it makes do something
     * @param by the script that runs it; null for a line
     * @param block the block it stands in; null for a line of its own
     */
    public synchronized Event command(
            String text, List<Member> members, @Nullable Owner by, @Nullable RecordedBlock block) {
        Set<Integer> robots = numbers(members);
        Set<Integer> begins = numbers(
                members.stream().filter(member -> hasFinished(member, by)).toList());
        Map<Integer, Long> finished = robots.isEmpty() ? Map.of() : finishedOthers(robots, by);
        return new Event(Event.Kind.COMMAND, nanos(), text, robots, begins, finished, block);
    }

    /**
     * Keeps that a robot has just begun a command of a script, after all that it had to do before.
     *
     * @param line the line that does it again; nothing is kept if it is empty
     */
    public synchronized void begun(String line, int number, Owner by, RecordedBlock block) {
        if (!line.isEmpty()) {
            Set<Integer> robot = Set.of(number);
            keep(new Event(Event.Kind.COMMAND, nanos(), line, robot, robot, finishedOthers(robot, by), block));
        }
    }

    /** Keeps that robots were waited for. */
    public synchronized void waited(String text, Set<Integer> robots, @Nullable RecordedBlock block) {
        keep(event(Event.Kind.WAIT, nanos(), text, robots, block));
    }

    /** Keeps that robots were stopped, unless nothing has moved them since they were stopped before. */
    public synchronized void stopped(Set<Integer> robots, long atNanos, @Nullable RecordedBlock block) {
        Event last = events.isEmpty() ? null : events.get(events.size() - 1);
        boolean again = last != null
                && last.kind() == Event.Kind.STOP
                && last.robots().containsAll(robots)
                && robots.stream().noneMatch(finishedBeforeManual::containsKey);
        if (!robots.isEmpty() && !again) {
            keep(stop(atNanos, names(robots) + " stop", robots, block));
        }
    }

    /** Keeps that the act of robots was ended. */
    public synchronized void calledOff(Set<Integer> robots, long atNanos, @Nullable RecordedBlock block) {
        keep(stop(atNanos, names(robots) + " act off", robots, block));
    }

    private Event stop(long atNanos, String text, Set<Integer> robots, @Nullable RecordedBlock block) {
        Set<Integer> moving = new TreeSet<>(robots);
        moving.removeIf(number -> !started.contains(number) && !finishedBeforeManual.containsKey(number));
        return new Event(Event.Kind.STOP, atNanos, text, robots, moving, Map.of(), block);
    }

    /** Begins a block or a file that is run as a script. */
    public synchronized RecordedBlock begin(String text, boolean waits) {
        return new RecordedBlock(text, nanos(), waits);
    }

    /** Ends a block; {@code completed} is whether it came to its own end. */
    public synchronized void end(RecordedBlock block, boolean completed) {
        block.end(nanos(), completed);
    }

    private static Event event(
            Event.Kind kind, long atNanos, String text, Set<Integer> robots, @Nullable RecordedBlock block) {
        return new Event(kind, atNanos, text, robots, Set.of(), Map.of(), block);
    }

    /**
     * Keeps an event in the order of times. Of a block that goes on for ever only the first commands are kept, and of a
     * session the first 200000.
     */
    public synchronized void keep(Event event) {
        if (event.text.isEmpty() || (event.block != null && !event.block.hasRoom())) {
            return;
        }
        if (events.size() >= mostEvents) {
            leftOut++;
            return;
        }
        int place = events.size();
        while (place > 0 && events.get(place - 1).atNanos > event.atNanos) {
            place--;
        }
        events.add(place, event);
        started.removeAll(event.finished.keySet());
        if (event.kind == Event.Kind.STOP) {
            started.removeAll(event.robots);
        } else if (event.kind == Event.Kind.COMMAND) {
            started.addAll(event.robots);
        }
    }

    private Map<Integer, Long> finishedOthers(Set<Integer> robots, @Nullable Owner by) {
        Map<Integer, Long> finished = new TreeMap<>();
        for (int number : started) {
            if (!robots.contains(number) && hasFinished(number, by)) {
                finished.put(number, lastAnswerNanos.getOrDefault(number, nanos()));
            }
        }
        return finished;
    }

    private boolean hasFinished(int number, @Nullable Owner by) {
        return team.members().stream()
                .filter(member -> member.number() == number)
                .anyMatch(member -> hasFinished(member, by));
    }

    /** A robot with an owner is not free, though it may have nothing to do just now. */
    private static boolean hasFinished(Member member, @Nullable Owner by) {
        return member.isIdle(by) && (member.owner() == null || member.owner() == by);
    }

    /** Everything so far, as a script. */
    public List<String> lines() {
        List<Event> all;
        synchronized (this) {
            all = List.copyOf(events);
        }
        return ReplayScript.of(all);
    }

    /**
     * Writes the script, which replaces an existing file as a whole. Blocks.
     *
     * @throws IOException if it cannot be written; an existing file is unchanged
     */
    public void save(Path file) throws IOException {
        List<String> all = new ArrayList<>();
        all.add("# A session of MAJIC; \"run FILE\" does it again.");
        all.addAll(lines());
        synchronized (this) {
            if (leftOut > 0) {
                all.add("# The session was longer: " + leftOut + " later commands are not kept.");
            }
        }
        WholeFile.replace(file, String.join(System.lineSeparator(), all) + System.lineSeparator());
    }

    /** An address or a file as a script would write it. */
    public static String quoted(String value) {
        return value.matches("[^\\s#\"]+") ? value : '"' + value + '"';
    }

    /** The numbers of robots. */
    public static Set<Integer> numbers(Collection<Member> members) {
        return members.stream().map(Member::number).collect(Collectors.toCollection(TreeSet::new));
    }

    /** Robots as a line names them: {@code 1,3}. */
    public static String names(Collection<Integer> robots) {
        return robots.stream().sorted().map(String::valueOf).collect(Collectors.joining(","));
    }

    /** Records from the team what was done without a command. */
    private final class TeamRecorder implements TeamListener {
        @Override
        public void answered(Answer answer) {
            synchronized (SessionRecord.this) {
                lastAnswerNanos.put(answer.robot(), nanos());
            }
        }

        @Override
        public void stopped(Collection<Member> members, long atNanos) {
            SessionRecord.this.stopped(numbers(members), atNanos, null);
        }

        /** Manual control takes a robot that is free; its commands are reported when it ends. */
        @Override
        public void ownerChanged(Member member) {
            Owner owner = member.owner();
            if (owner != null && owner.kind() == Owner.Kind.MANUAL) {
                synchronized (SessionRecord.this) {
                    finishedBeforeManual.put(member.number(), finishedOthers(Set.of(member.number()), null));
                }
            }
        }

        @Override
        public void drivenManually(Member member, List<ManualCommand> commands) {
            synchronized (SessionRecord.this) {
                Set<Integer> robot = Set.of(member.number());
                Map<Integer, Long> finished = finishedBeforeManual.getOrDefault(member.number(), Map.of());
                finishedBeforeManual.remove(member.number());
                Set<Integer> begins = robot;
                for (ManualCommand command : commands) {
                    String line = member.number() + " " + command.text();
                    keep(new Event(Event.Kind.COMMAND, command.atNanos(), line, robot, begins, finished, null));
                    finished = Map.of();
                    begins = Set.of();
                }
                lastAnswerNanos.put(member.number(), nanos());
            }
        }
    }

    /**
     * Something that was done in a session. Immutable.
     *
     * @param kind what it is
     * @param atNanos when it was done, on the clock of the team; of a wait, when it was over
     * @param text the lines that do it again
     * @param robots those that it makes do something, stops or waits for
     * @param begins those of them that had nothing to do before it; of a stop, those that may have been moving
     * @param finished others that had finished their commands by then, and when
     * @param block the block it was done by; null for a line of its own
     */
    public record Event(
            Kind kind,
            long atNanos,
            String text,
            Set<Integer> robots,
            Set<Integer> begins,
            Map<Integer, Long> finished,
            @Nullable RecordedBlock block) {
        /** What can be recorded. */
        enum Kind {
            /** A robot was connected, which takes its own time when it is done again. */
            ADD,
            /** A command. */
            COMMAND,
            /** Robots were waited for. */
            WAIT,
            /** Robots were stopped, or their act was ended. */
            STOP,
            /** A whole block, from its beginning on. */
            BLOCK
        }
    }
}
