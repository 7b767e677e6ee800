package majic.script.record;

import java.io.IOException;
import java.nio.file.Files;
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
import majic.team.Answer;
import majic.team.ManualCommand;
import majic.team.Member;
import majic.team.Owner;
import majic.team.Team;
import majic.team.TeamListener;
import org.jspecify.annotations.Nullable;

/**
 * Collects what is done in a session, with its times, so that a script can do it again: commands, and what reaches the
 * robots without a command, as stops by button or key and manual control. The team reports these after they were sent, so
 * recording delays none of them. Thread-safe.
 */
public final class SessionRecord {
    private final Team team;
    private final List<RecordedEvent> events = new ArrayList<>();
    private final Map<Integer, Long> lastAnswerNanos = new HashMap<>();

    /** For each robot under manual control, the others that had finished before, and when. */
    private final Map<Integer, Map<Integer, Long>> finishedBeforeManual = new HashMap<>();

    private final Set<Integer> started = new TreeSet<>();

    public SessionRecord(Team team) {
        this.team = team;
        team.addListener(new TeamRecorder());
    }

    /** The time on the clock of the team, nanoseconds. */
    public long nanos() {
        return team.time().nanos();
    }

    /** Keeps that a robot joined. */
    public synchronized void added(String address, int number) {
        String line = "add " + quoted(address) + " as " + number;
        keep(new RecordedEvent(RecordedEvent.Kind.ADD, nanos(), line, Set.of(number), Set.of(), Map.of(), null));
    }

    /** Keeps that a robot was removed at a time, and stopped by that if it was busy. */
    public synchronized void removed(int number, boolean wasBusy, long atNanos) {
        if (wasBusy) {
            stopped(Set.of(number), atNanos, null);
        }
        keep(event(RecordedEvent.Kind.COMMAND, atNanos, "remove " + number, Set.of(number), null));
        started.remove(number);
    }

    /**
     * Creates the entry for a command that is about to run; nothing is kept before {@link #keep}.
     *
     * @param text the line that does it again
     * @param robots those it makes do something
     * @param by the script that runs it; null for a line
     * @param block the block it stands in; null for a line of its own
     */
    public synchronized RecordedEvent command(
            String text, Set<Integer> robots, @Nullable Owner by, @Nullable RecordedBlock block) {
        Set<Integer> begins =
                robots.stream().filter(number -> hasFinished(number, by)).collect(Collectors.toSet());
        Map<Integer, Long> finished = robots.isEmpty() ? Map.of() : finishedOthers(robots, by);
        return new RecordedEvent(RecordedEvent.Kind.COMMAND, nanos(), text, robots, begins, finished, block);
    }

    /** Keeps that robots were waited for. */
    public synchronized void waited(String text, Set<Integer> robots, @Nullable RecordedBlock block) {
        keep(event(RecordedEvent.Kind.WAIT, nanos(), text, robots, block));
    }

    /** Keeps that robots were stopped, unless nothing has moved them since they were stopped before. */
    public synchronized void stopped(Set<Integer> robots, long atNanos, @Nullable RecordedBlock block) {
        RecordedEvent last = events.isEmpty() ? null : events.get(events.size() - 1);
        boolean again = last != null
                && last.kind() == RecordedEvent.Kind.STOP
                && last.robots().containsAll(robots)
                && robots.stream().noneMatch(finishedBeforeManual::containsKey);
        if (!robots.isEmpty() && !again) {
            keep(stop(atNanos, RecordedEvent.names(robots) + " stop", robots, block));
        }
    }

    /** Keeps that the act of robots was ended. */
    public synchronized void calledOff(Set<Integer> robots, long atNanos, @Nullable RecordedBlock block) {
        keep(stop(atNanos, RecordedEvent.names(robots) + " act off", robots, block));
    }

    private RecordedEvent stop(long atNanos, String text, Set<Integer> robots, @Nullable RecordedBlock block) {
        Set<Integer> moving = new TreeSet<>(robots);
        moving.removeIf(number -> !started.contains(number) && !finishedBeforeManual.containsKey(number));
        return new RecordedEvent(RecordedEvent.Kind.STOP, atNanos, text, robots, moving, Map.of(), block);
    }

    /** Begins a block or a file that is run as a script. */
    public synchronized RecordedBlock begin(String text, boolean waits) {
        return new RecordedBlock(text, nanos(), waits);
    }

    /** Ends a block; {@code completed} tells whether it came to its own end. */
    public synchronized void end(RecordedBlock block, boolean completed) {
        block.end(nanos(), completed);
    }

    private static RecordedEvent event(
            RecordedEvent.Kind kind, long atNanos, String text, Set<Integer> robots, @Nullable RecordedBlock block) {
        return new RecordedEvent(kind, atNanos, text, robots, Set.of(), Map.of(), block);
    }

    /** Keeps an event in the order of times. Of a block that goes on for ever only the first commands are kept. */
    public synchronized void keep(RecordedEvent event) {
        if (event.text().isEmpty() || (event.block() != null && !event.block().hasRoom())) {
            return;
        }
        int place = events.size();
        while (place > 0 && events.get(place - 1).atNanos() > event.atNanos()) {
            place--;
        }
        events.add(place, event);
        started.removeAll(event.finished().keySet());
        if (event.kind() == RecordedEvent.Kind.STOP) {
            started.removeAll(event.robots());
        } else if (event.kind() == RecordedEvent.Kind.COMMAND) {
            started.addAll(event.robots());
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

    /** A robot with an owner is not free, though it may have nothing to do just now. */
    private boolean hasFinished(int number, @Nullable Owner by) {
        return team.members().stream()
                .filter(member -> member.number() == number)
                .anyMatch(member -> member.isIdle(by) && (member.owner() == null || member.owner() == by));
    }

    /** Everything so far, as a script. */
    public List<String> lines() {
        List<RecordedEvent> all;
        synchronized (this) {
            all = List.copyOf(events);
        }
        return ReplayScript.of(all);
    }

    public void save(Path file) throws IOException {
        List<String> all = new ArrayList<>();
        all.add("# A session of MAJIC; \"run FILE\" does it again.");
        all.addAll(lines());
        Files.write(file, all);
    }

    /** An address or a file as a script would write it. */
    public static String quoted(String value) {
        return value.matches("[^\\s#\"]+") ? value : '"' + value + '"';
    }

    /** The numbers of robots. */
    public static Set<Integer> numbers(Collection<Member> members) {
        return members.stream().map(Member::number).collect(Collectors.toCollection(TreeSet::new));
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
                    keep(new RecordedEvent(
                            RecordedEvent.Kind.COMMAND, command.atNanos(), line, robot, begins, finished, null));
                    finished = Map.of();
                    begins = Set.of();
                }
                lastAnswerNanos.put(member.number(), nanos());
            }
        }
    }
}
