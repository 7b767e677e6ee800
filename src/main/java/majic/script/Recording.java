package majic.script;

import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import majic.script.syntax.Command;
import majic.script.syntax.Statement;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * Keeps what one line or one script does in the session's record. What a behaviour does is not kept, because the line
 * that runs it is.
 *
 * @param record where it is kept; null for a behaviour
 * @param block the block that is run; null for a line
 */
record Recording(@Nullable SessionRecord record, @Nullable RecordedBlock block) {
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

    /** Does a command, and keeps it with the time at which it was given. */
    void command(Statement.ForRobots line, List<Member> members, Execution execution, Runnable doing) {
        if (record == null) {
            doing.run();
            return;
        }
        Command command = line.command();
        Set<Integer> robots = numbers(members);
        if (command instanceof Command.Await) {
            doing.run();
            record.waited(ReplayScript.numbers(robots) + " wait", robots, block);
        } else if (command instanceof Command.Stop || command instanceof Command.ActOff) {
            long atNanos = execution.session().team().time().nanos();
            doing.run();
            keepStop(command, robots, atNanos, execution);
        } else {
            boolean moves = Commanded.orders(command);
            RecordedEvent event = record.command(
                    ReplayWording.of(
                            command,
                            robots,
                            execution.isTyped(),
                            execution.session().behaviours().acts()),
                    moves ? robots : Set.of(),
                    execution.owner(),
                    block);
            doing.run();
            record.keep(event);
        }
    }

    /** The stop of a line is told by the team. */
    private void keepStop(Command command, Set<Integer> robots, long atNanos, Execution execution) {
        if (record != null && command instanceof Command.ActOff) {
            record.calledOff(robots, atNanos, block);
        } else if (record != null && execution.isScript()) {
            record.stopped(robots, atNanos, block);
        }
    }

    /** Keeps that all robots were waited for. */
    void waitedForAll(Collection<Member> members) {
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
