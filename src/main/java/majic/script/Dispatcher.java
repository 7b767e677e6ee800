package majic.script;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.script.syntax.Mistake;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Statement;
import majic.team.Member;
import majic.team.StopCount;
import majic.team.Team;
import majic.time.Signal;

/**
 * Gets checked lines carried out: at once on the caller's thread, beside it, or in their turn behind others. Thread-safe.
 */
final class Dispatcher {
    /** How many lines of a person may wait behind a {@code wait}. */
    static final int MOST_HELD = 100;

    private final Session session;
    private final Team team;
    private final Source source;
    private final Object asker;
    private final Selection selection;
    private final Tally tally = new Tally();
    private final LineQueue queue;
    private final LineQueue comings;
    private final AtomicInteger beside = new AtomicInteger();
    private final StopCount ownStops = new StopCount();

    /**
     * A dispatcher without lines.
     *
     * @param asker what the answers to its lines carry
     */
    Dispatcher(Session session, Source source, Object asker) {
        this.asker = asker;
        this.session = session;
        this.team = session.team();
        this.source = source;
        this.selection = new Selection(team);
        this.queue = new LineQueue(team, "script lines", this::inTurn);
        this.comings = new LineQueue(team, "adding robots", this::attempt);
    }

    Selection selection() {
        return selection;
    }

    /** What all lines came to so far. */
    Tally tally() {
        return tally;
    }

    boolean teamMayChange() {
        return queue.teamMayChange();
    }

    /** Waits until a line would not have to wait behind many others. */
    void awaitRoom() throws InterruptedException {
        team.changes().await(this::hasRoom, Signal.FOR_EVER);
    }

    /** Waits until all lines have ended, with all that they began. */
    void awaitAll() throws InterruptedException {
        team.changes().await(this::isDone, Signal.FOR_EVER);
    }

    boolean hasRoom() {
        return queue.size() < MOST_HELD;
    }

    /** Whether all lines have ended, with all that they began. */
    boolean isDone() {
        return queue.isEmpty()
                && comings.isEmpty()
                && beside.get() == 0
                && tally.allEnded()
                && team.members().stream().noneMatch(Member::isStopping);
    }

    /**
     * Takes a line. Never waits. A line that names files is checked, and carried out, on a thread of this source.
     *
     * @param refused gets the reason if a file the line names does not let it be done
     * @param failed gets the reason if the line is refused when its turn comes
     * @throws BotException if it cannot be done now; nothing happened
     * @throws ScriptException if it cannot be done with the robots there are; nothing happened
     */
    void give(Statement statement, String text, Consumer<String> refused, Consumer<String> failed) {
        Set<Integer> robots = Given.robots(statement, selection);
        Given line = new Given(statement, text, robots, stops(robots), refused, failed, false);
        if (goesNow(line)) {
            perform(line, Execution.Manner.AT_ONCE);
        } else if (goesBeside(line) && !line.namesFile() && queue.isEmpty()) {
            begin(line);
        } else if (source == Source.PROMPT && queue.size() >= MOST_HELD) {
            throw new BotException("too many lines wait already (" + MOST_HELD + "); \"stop\" ends the wait");
        } else {
            queue.add(line);
        }
    }

    private boolean goesNow(Given line) {
        boolean free = queue.isEmpty() && line.isQuick() && !line.namesFile();
        boolean inTurn = free && hasRoom(line) && !line.isActOff();
        return switch (source) {
            case PROMPT -> free || line.overtakes();
            case PIPE -> inTurn;
            case SOCKET -> line.isStop() || inTurn;
        };
    }

    /** For a person everything that takes its time runs beside what is typed next, but a wait, which holds it. */
    private boolean goesBeside(Given line) {
        return source == Source.PROMPT && !line.isWait() && !line.isQuick();
    }

    /** Whether the files that a line names let it be done; if not, says so. Reads them, so it may block. */
    private boolean filesAllow(Given line) {
        if (!line.namesFile()) {
            return true;
        }
        Optional<String> wrong = wrongWithFiles(line);
        wrong.ifPresent(line.refused());
        return wrong.isEmpty();
    }

    private Optional<String> wrongWithFiles(Given line) {
        try {
            return Checker.check(List.of(line.statement()), session, selection).stream()
                    .findFirst()
                    .map(Mistake::message);
        } catch (RuntimeException | Error e) {
            return Optional.of(Mishap.told(line.title(), e));
        }
    }

    private boolean wasStopped(Given line) {
        return line.mayMove() && line.stops() != stops(line.robots());
    }

    private boolean hasRoom(Given line) {
        return !(line.statement() instanceof Statement.ForRobots robots)
                || selection.present(robots.robots()).stream().allMatch(Member::hasRoom);
    }

    /** Robots that are added one after the other get their numbers in that order. */
    private void begin(Given line) {
        if (line.isAdd()) {
            comings.add(line);
            return;
        }
        beside.incrementAndGet();
        boolean begun = team.time().begin("script: " + line.title(), () -> {
            try {
                attempt(line);
            } finally {
                ended();
            }
        });
        if (!begun) {
            ended();
            line.failed().accept(line.title() + ": the system has no thread left for it; end an act or a program");
        }
    }

    private void ended() {
        beside.decrementAndGet();
        team.changes().raise();
    }

    private void inTurn(Given line) {
        if (wasStopped(line)) {
            tellStopped(line);
        } else if (line.sent()) {
            awaitFreed(line);
        } else if (filesAllow(line)) {
            takeTurn(line);
        }
    }

    /** Waits until the robots of a stop have stopped, and what it ended has given them back. */
    private void awaitFreed(Given stop) {
        try {
            team.changes().await(() -> stopped(stop).stream().noneMatch(Execution::isEnding), Signal.FOR_EVER);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private List<Member> stopped(Given stop) {
        return stop.statement() instanceof Statement.ForRobots line ? selection.present(line.robots()) : team.members();
    }

    private void tellStopped(Given line) {
        tally.fail(line.title());
        session.say(Line.Kind.ANSWER, line.title() + ": not run: stopped", asker);
    }

    private void takeTurn(Given line) {
        if (wasStopped(line)) {
            tellStopped(line);
        } else if (goesBeside(line)) {
            begin(line);
        } else {
            attempt(line);
        }
    }

    /** Carries a line out whose giver has gone; what goes wrong can only be said. */
    private void attempt(Given line) {
        try {
            perform(line, Execution.Manner.IN_TURN);
        } catch (ExecutionEnded e) {
            tally.fail(line.title());
            session.say(Line.Kind.ANSWER, line.title() + ": " + e.ending(), asker);
        } catch (ScriptException | BotException e) {
            line.failed().accept(String.valueOf(e.getMessage()));
        } catch (RuntimeException | Error e) {
            line.failed().accept(line.title() + ": " + Mishap.told(line.title(), e));
        }
    }

    private void perform(Given line, Execution.Manner unlessTyped) {
        Execution execution = Execution.ofLine(
                        session, source == Source.PROMPT ? Execution.Manner.TYPED : unlessTyped, tally)
                .askedBy(asker)
                .unless(() -> wasStopped(line));
        if (line.isStop()) {
            stop(line, execution);
        } else if (line.isBlock()) {
            runBlock(line, execution);
        } else {
            new Interpreter(execution).run(List.of(line.statement()));
        }
    }

    private void runBlock(Given line, Execution execution) {
        boolean waits = source == Source.PROMPT;
        Execution script = execution.asScript(line.title(), line.text().strip(), waits);
        if (!new ScriptRun(script, line.title(), "", waits).run(List.of(line.statement()))) {
            tally.fail(line.title());
        }
    }

    /** A stop drops the lines that are held for its robots, unless it is one of the held itself and had its turn. */
    private void stop(Given line, Execution execution) {
        Runnable stopping = () -> new Interpreter(execution).run(List.of(line.statement()));
        if (queue.isEmpty() || queue.isCurrent(line)) {
            ownStops.during(stopping);
        } else {
            stopping.run();
        }
        if (queue.isCurrent(line)) {
            awaitFreed(line);
        } else if (source != Source.PROMPT) {
            queue.add(line.asSent());
        }
    }

    private long stops(Set<Integer> robots) {
        return session.stops().ofOthers(robots, ownStops);
    }
}
