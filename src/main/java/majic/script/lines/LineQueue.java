package majic.script.lines;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;
import majic.script.run.CommandTrait;
import majic.team.Team;
import org.jspecify.annotations.Nullable;

/** The lines that wait for their turn, and the thread that runs them one after the other. Thread-safe. */
final class LineQueue {
    private final Team team;
    private final String name;
    private final Consumer<PreparedLine> work;
    private final Deque<PreparedLine> waiting = new ArrayDeque<>();
    private boolean running;
    private @Nullable PreparedLine current;

    /**
     * An empty queue without a thread.
     *
     * @param team whose clock the thread uses, and whose changes wake threads that wait for the queue
     * @param name what a thread dump shows
     * @param work runs a line, however long it takes; must not throw
     */
    LineQueue(Team team, String name, Consumer<PreparedLine> work) {
        this.team = team;
        this.name = name;
        this.work = work;
    }

    synchronized boolean isEmpty() {
        return !running;
    }

    synchronized boolean isCurrent(PreparedLine line) {
        return line == current;
    }

    synchronized int size() {
        return waiting.size();
    }

    /** Whether a line before the next one may add or remove robots. */
    synchronized boolean teamMayChange() {
        return waiting.stream().anyMatch(LineQueue::changesTeam) || (current != null && changesTeam(current));
    }

    private static boolean changesTeam(PreparedLine line) {
        return line.has(CommandTrait.CHANGES_TEAM);
    }

    void add(PreparedLine line) {
        synchronized (this) {
            waiting.add(line);
            if (running) {
                return;
            }
            running = true;
        }
        team.time().thread(name, this::run).start();
    }

    private void run() {
        for (PreparedLine line = next(); line != null; line = next()) {
            work.accept(line);
            team.changes().raise();
        }
        team.changes().raise();
    }

    private synchronized @Nullable PreparedLine next() {
        current = waiting.poll();
        running = current != null;
        return current;
    }
}
