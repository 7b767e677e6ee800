package majic.script.lines;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;
import majic.script.run.Trait;
import majic.team.Team;
import org.jspecify.annotations.Nullable;

/** The lines that wait for their turn, and the thread that runs them one after the other. Thread-safe. */
final class LineQueue {
    private final Team team;
    private final String name;
    private final Consumer<SubmittedLine> carryOut;
    private final Deque<SubmittedLine> waiting = new ArrayDeque<>();
    private boolean running;
    private @Nullable SubmittedLine current;

    /**
     * An empty queue without a thread.
     *
     * @param team whose clock the thread uses, and whose changes wake threads that wait for the queue
     * @param name what a thread dump shows
     * @param carryOut runs a line, however long it takes; must not throw
     */
    LineQueue(Team team, String name, Consumer<SubmittedLine> carryOut) {
        this.team = team;
        this.name = name;
        this.carryOut = carryOut;
    }

    synchronized boolean isEmpty() {
        return !running;
    }

    synchronized boolean isCurrent(SubmittedLine line) {
        return line == current;
    }

    synchronized int size() {
        return waiting.size();
    }

    /** Whether a line before the next one may let robots come or go. */
    synchronized boolean teamMayChange() {
        return waiting.stream().anyMatch(LineQueue::changesTeam) || (current != null && changesTeam(current));
    }

    private static boolean changesTeam(SubmittedLine line) {
        return line.has(Trait.CHANGES_TEAM);
    }

    void add(SubmittedLine line) {
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
        for (SubmittedLine line = next(); line != null; line = next()) {
            carryOut.accept(line);
            team.changes().raise();
        }
        team.changes().raise();
    }

    private synchronized @Nullable SubmittedLine next() {
        current = waiting.poll();
        running = current != null;
        return current;
    }
}
