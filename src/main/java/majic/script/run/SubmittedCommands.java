package majic.script.run;

import java.util.Collection;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import majic.team.Answer;
import majic.team.Member;
import majic.team.QueuedCommand;
import org.jspecify.annotations.Nullable;

/** Counts submitted commands: which are still under way, and whether one did not come to a good end. Thread-safe. */
public final class SubmittedCommands {
    private final Map<QueuedCommand, Member> open = new LinkedHashMap<>();
    private final Set<QueuedCommand> forgiven = new HashSet<>();
    private Optional<Trouble> trouble = Optional.empty();

    /**
     * The first command that did not end well.
     *
     * @param outcome how it ended
     * @param text the command with its robot
     * @param robot the robot it was for; null for a whole line
     */
    record Trouble(
            Answer.Outcome outcome, String text, @Nullable Member robot) {}

    synchronized void add(Member member, QueuedCommand command) {
        look();
        open.put(command, member);
    }

    /** Ignores how the commands of some robots end, because their source stops them itself. */
    synchronized void forget(Collection<Member> members) {
        look();
        open.forEach((command, member) -> {
            if (members.contains(member)) {
                forgiven.add(command);
            }
        });
    }

    public synchronized void fail(String what) {
        if (trouble.isEmpty()) {
            trouble = Optional.of(new Trouble(Answer.Outcome.FAILED, what, null));
        }
    }

    public synchronized Optional<Trouble> trouble() {
        look();
        return trouble;
    }

    public synchronized boolean allEnded() {
        look();
        return open.isEmpty();
    }

    /** Whether a command of some kind is still under way. */
    synchronized boolean hasOpen(Predicate<QueuedCommand> kind) {
        look();
        return open.keySet().stream().anyMatch(kind);
    }

    private void look() {
        for (Iterator<Map.Entry<QueuedCommand, Member>> all = open.entrySet().iterator(); all.hasNext(); ) {
            Map.Entry<QueuedCommand, Member> entry = all.next();
            Answer.Outcome outcome = entry.getKey().outcome();
            if (outcome == null) {
                continue;
            }
            note(entry.getKey(), outcome, entry.getValue());
            if (entry.getKey().hasEnded()) {
                all.remove();
                forgiven.remove(entry.getKey());
            }
        }
    }

    private void note(QueuedCommand command, Answer.Outcome outcome, Member robot) {
        if (outcome != Answer.Outcome.DONE && !forgiven.contains(command) && trouble.isEmpty()) {
            trouble = Optional.of(new Trouble(outcome, robot.number() + " " + command.text(), robot));
        }
    }
}
