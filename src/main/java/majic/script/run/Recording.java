package majic.script.run;

import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import majic.script.record.RecordedBlock;
import majic.script.record.RecordedEvent;
import majic.script.record.ReplayScript;
import majic.script.record.SessionRecord;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * Keeps what one line or one script does in the session's record. What a behaviour does is not kept, because the line
 * that runs it is.
 *
 * @param record where it is kept; null for a behaviour
 * @param block the block that is run; null for a line
 */
public record Recording(
        @Nullable SessionRecord record, @Nullable RecordedBlock block) {
    /** Keeps nothing. */
    static final Recording OFF = new Recording(null, null);

    /** A block that begins now; see {@link SessionRecord#begin}. */
    Recording begin(String text, boolean waits) {
        return record == null ? OFF : new Recording(record, record.begin(text, waits));
    }

    /** Ends the block; {@code completed} tells whether it came to its own end. */
    void end(boolean completed) {
        if (record != null && block != null) {
            record.end(block, completed);
        }
    }

    /** Runs a command, and keeps it with the time at which it was given. */
    void run(RobotAction action, List<Member> robots, Execution execution) {
        if (record == null) {
            action.run(execution, robots);
            return;
        }
        Set<Integer> numbers = numbers(robots);
        switch (action.scheduling()) {
            case HOLDS -> {
                action.run(execution, robots);
                record.waited(ReplayScript.numbers(numbers) + " " + action.text(), numbers, block);
            }
            case STOP -> {
                long atNanos = execution.time().nanos();
                action.run(execution, robots);
                keepStop(numbers, atNanos, execution);
            }
            case AT_ONCE_IF_TYPED -> {
                long atNanos = execution.time().nanos();
                action.run(execution, robots);
                record.calledOff(numbers, atNanos, block);
            }
            default -> {
                RecordedEvent event = command(action, numbers, execution);
                action.run(execution, robots);
                record.keep(event);
            }
        }
    }

    private RecordedEvent command(RobotAction action, Set<Integer> numbers, Execution execution) {
        String text = action.replayText(execution.isTyped());
        return record.command(
                text.isEmpty() ? "" : ReplayScript.numbers(numbers) + " " + text,
                action.has(Trait.COMMANDS_ROBOTS) ? numbers : Set.of(),
                execution.owner(),
                block);
    }

    /** The team reports the stop of a line. */
    private void keepStop(Set<Integer> robots, long atNanos, Execution execution) {
        if (execution.isScript()) {
            record.stopped(robots, atNanos, block);
        }
    }

    /** Keeps that all robots were waited for. */
    public void waitedForAll(Collection<Member> members) {
        if (record != null) {
            record.waited("wait", numbers(members), block);
        }
    }

    /** Keeps that a script stopped robots as it ended. */
    void stopped(Collection<Member> members, long atNanos) {
        if (record != null) {
            record.stopped(numbers(members), atNanos, block);
        }
    }

    private static Set<Integer> numbers(Collection<Member> members) {
        return members.stream().map(Member::number).collect(Collectors.toCollection(TreeSet::new));
    }
}
