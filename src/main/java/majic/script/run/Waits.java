package majic.script.run;

import java.util.Collection;
import java.util.function.Predicate;
import majic.script.record.SessionRecord;
import majic.team.Member;
import majic.team.QueuedCommand;

/**
 * What the commands of a line or script wait for. Each wait blocks, and ends early with {@link ExecutionEnded} if the
 * line or script has to end. Used by the thread that runs it.
 */
public final class Waits {
    private final Execution execution;
    private final SubmittedCommands submitted;

    /**
     * The waits of a line or script.
     *
     * @param submitted what was submitted by its source so far
     */
    Waits(Execution execution, SubmittedCommands submitted) {
        this.execution = execution;
        this.submitted = submitted;
    }

    /** Waits for a time. */
    public void pause(double seconds) {
        execution.await(() -> false, seconds);
    }

    /** Waits until the commands of some kind that were submitted before have had their turn. */
    public void awaitCommands(Predicate<QueuedCommand> kind) {
        execution.await(() -> !submitted.hasOpen(kind), Double.POSITIVE_INFINITY);
    }

    /** Waits for all robots of the line or script, and records that. */
    public void awaitAll() {
        Collection<Member> all = execution.allRobots();
        awaitFinished(all);
        SessionRecord record = execution.record();
        if (record != null) {
            record.waited("wait", SessionRecord.numbers(all), execution.block());
        }
    }

    /** Waits until robots are idle and have no other owner. */
    public void awaitFinished(Collection<Member> members) {
        execution.await(() -> members.stream().allMatch(this::isFinished), Double.POSITIVE_INFINITY);
    }

    private boolean isFinished(Member member) {
        return isIdle(member) && (member.owner() == null || member.owner() == execution.owner());
    }

    /** Waits until robots have finished their commands, unless they have another owner. */
    void awaitReadable(Collection<Member> members) {
        execution.await(() -> members.stream().allMatch(this::isReadable), Double.POSITIVE_INFINITY);
    }

    private boolean isReadable(Member member) {
        return isIdle(member) || (member.owner() != null && member.owner() != execution.owner());
    }

    private boolean isIdle(Member member) {
        return member.isIdle(execution.owner());
    }
}
