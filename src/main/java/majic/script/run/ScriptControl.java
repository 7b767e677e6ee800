package majic.script.run;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeSet;
import majic.bot.Value;
import majic.team.QueuedCommand;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/**
 * Pauses a running script, lets it go on line by line, ends it, and reports its place. A paused script begins no
 * statement, and its robots begin none of its commands, those in their queues included; what a robot has begun goes on
 * to its end. Controls one run. Thread-safe; returns at once, except for {@link #end()}.
 */
public final class ScriptControl {
    private final Signal changes;
    private final List<Turn> turns = new ArrayList<>();
    private boolean paused;
    private boolean ending;
    private Runnable end = () -> {};
    private String outcome = "";
    private @Nullable Map<String, Value> valuesBefore;

    /**
     * The place of a script. Lines count from 1.
     *
     * @param paused whether it goes on only by single lines
     * @param running the lines of which something runs
     * @param next the line that begins next when the script goes on; empty unless one waits
     * @param values what the names stood for when the line that begins next, or else the last one, was reached, in the
     *     order of the names
     * @param outcome how the script ended: {@code done (3.2 s)}, {@code stopped}; empty while it runs
     */
    public record Progress(
            boolean paused, Set<Integer> running, OptionalInt next, List<NamedValue> values, String outcome) {
        /** Whether the script has ended and given its robots back. */
        public boolean isOver() {
            return !outcome.isEmpty();
        }
    }

    /**
     * A name with its value.
     *
     * @param name in lower case, without {@code $}
     * @param changed whether the line before gave it this value
     */
    public record NamedValue(String name, Value value, boolean changed) {}

    /**
     * The control of a script that has not begun.
     *
     * @param changes wakes the threads of the script and of its robots: the signal of the team
     * @param paused whether the script waits before its first line
     */
    public ScriptControl(Signal changes, boolean paused) {
        this.changes = changes;
        this.paused = paused;
    }

    /** Begins nothing further until {@link #resume} or {@link #step}. */
    public void pause() {
        synchronized (this) {
            paused = true;
            turns.forEach(turn -> turn.admitted = false);
        }
    }

    /** Goes on after a pause. */
    public void resume() {
        synchronized (this) {
            paused = false;
        }
        changes.raise();
    }

    /** Begins the next line and pauses behind it; has no effect while none waits. */
    public void step() {
        synchronized (this) {
            paused = true;
            turns.stream().filter(Turn::isWaiting).findFirst().ifPresent(turn -> turn.admitted = true);
        }
        changes.raise();
    }

    /** Stops the robots of the script and ends it, as a stop of these robots does; blocks as that stop does. */
    public void end() {
        Runnable now;
        synchronized (this) {
            ending = true;
            now = end;
        }
        now.run();
    }

    /** Returns where the script is now. */
    public synchronized Progress progress() {
        Set<Integer> running = new TreeSet<>();
        turns.stream().filter(Turn::isRunning).forEach(turn -> running.add(turn.line));
        Optional<Turn> next = turns.stream().filter(Turn::isWaiting).findFirst();
        Optional<Turn> shown = next.or(() -> turns.stream().reduce((first, second) -> second));
        return new Progress(
                paused,
                running,
                paused && next.isPresent() ? OptionalInt.of(next.get().line) : OptionalInt.empty(),
                shown.map(turn -> turn.values).orElse(List.of()),
                outcome);
    }

    /** Sets what ends the script, and ends it if that was requested before. */
    void begun(Runnable ends) {
        boolean now;
        synchronized (this) {
            end = ends;
            now = ending;
        }
        if (now) {
            ends.run();
        }
    }

    /** Keeps how the script ended; of several outcomes the first counts. */
    public synchronized void ended(String how) {
        if (outcome.isEmpty()) {
            outcome = how;
            turns.clear();
        }
    }

    /**
     * Creates the turn of the next statement of the script itself; ends that of the statement before it.
     *
     * @param names what the names stand for there
     */
    synchronized Turn reach(int line, Map<String, Value> names) {
        leave();
        turns.removeIf(Turn::isOver);
        Turn turn = new Turn(line, compared(names));
        turns.add(turn);
        return turn;
    }

    /** A name that is known again behind a procedure is compared with the value that it had before the call. */
    private List<NamedValue> compared(Map<String, Value> names) {
        Map<String, Value> before = valuesBefore;
        List<NamedValue> values = names.entrySet().stream()
                .map(named -> new NamedValue(
                        named.getKey(),
                        named.getValue(),
                        before != null && !named.getValue().equals(before.get(named.getKey()))))
                .toList();
        Map<String, Value> known = before == null ? new HashMap<>() : before;
        known.putAll(names);
        valuesBefore = known;
        return values;
    }

    /** Ends the turn of the last statement, whose commands may still wait or run. */
    synchronized void leave() {
        if (!turns.isEmpty()) {
            turns.get(turns.size() - 1).left = true;
        }
    }

    /** A statement each time its turn comes, with its commands to robots. Guarded by the lock of its control. */
    final class Turn {
        private final int line;
        private final List<NamedValue> values;
        private final List<GatedCommand> commands = new ArrayList<>();
        private boolean admitted;
        private boolean entered;
        private boolean left;

        private Turn(int line, List<NamedValue> values) {
            this.line = line;
            this.values = values;
        }

        /** Whether the statement, or a command of it, may begin. */
        boolean mayBegin() {
            synchronized (ScriptControl.this) {
                return !paused || admitted;
            }
        }

        /** Begins the statement. */
        void enter() {
            synchronized (ScriptControl.this) {
                entered = true;
            }
        }

        /** Adds a command to a robot, which waits until it may begin. */
        GatedCommand command(QueuedCommand queued) {
            synchronized (ScriptControl.this) {
                GatedCommand command = new GatedCommand(this, queued);
                commands.add(command);
                return command;
            }
        }

        private boolean isWaiting() {
            return !entered || commands.stream().anyMatch(GatedCommand::isWaiting);
        }

        private boolean isRunning() {
            return (entered && !left) || commands.stream().anyMatch(GatedCommand::isRunning);
        }

        private boolean isOver() {
            commands.removeIf(GatedCommand::hasEnded);
            return left && commands.isEmpty();
        }
    }

    /** A command in the queue of a robot that begins only when the script may go on. */
    final class GatedCommand {
        private final Turn turn;
        private final QueuedCommand command;
        private boolean begun;

        private GatedCommand(Turn turn, QueuedCommand command) {
            this.turn = turn;
            this.command = command;
        }

        boolean mayBegin() {
            return turn.mayBegin();
        }

        void begin() {
            synchronized (ScriptControl.this) {
                begun = true;
            }
        }

        private boolean isWaiting() {
            return !begun && !hasEnded();
        }

        private boolean isRunning() {
            return begun && !hasEnded();
        }

        private boolean hasEnded() {
            return command.hasEnded();
        }
    }
}
