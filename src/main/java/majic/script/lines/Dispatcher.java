package majic.script.lines;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.log.Line;
import majic.script.conditions.Selection;
import majic.script.run.Actions;
import majic.script.run.Execution;
import majic.script.run.ExecutionEnded;
import majic.script.run.InternalError;
import majic.script.run.Interpreter;
import majic.script.run.QueuedCommands;
import majic.script.run.Scheduling;
import majic.script.run.ScriptRun;
import majic.script.run.SessionState;
import majic.script.run.Trait;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Statement;
import majic.team.Member;
import majic.team.StopCount;
import majic.team.Team;
import majic.time.Signal;

/**
 * Runs checked lines: at once on the caller's thread, beside it, or in their turn. Thread-safe.
 */
public final class Dispatcher {
    /** How many lines of a person may wait behind a {@code wait}. */
    static final int MOST_HELD = 100;

    private final SessionState state;
    private final Actions actions;
    private final Team team;
    private final Source source;
    private final Object asker;
    private final Selection selection;
    private final LinePreparation preparation;
    private final QueuedCommands lines = new QueuedCommands();
    private final LineQueue queue;
    private final LineQueue adding;
    private final AtomicInteger beside = new AtomicInteger();
    private final StopCount ownStops = new StopCount();

    /**
     * A dispatcher without lines.
     *
     * @param asker what the answers to its lines carry
     */
    public Dispatcher(SessionState state, Actions actions, Source source, Object asker) {
        this.asker = asker;
        this.state = state;
        this.actions = actions;
        this.team = state.team();
        this.source = source;
        this.selection = new Selection(team);
        this.preparation = new LinePreparation(actions, selection);
        this.queue = new LineQueue(team, "script lines", this::inTurn);
        this.adding = new LineQueue(team, "adding robots", this::attempt);
    }

    Selection selection() {
        return selection;
    }

    /** What all lines came to so far. */
    public QueuedCommands lines() {
        return lines;
    }

    /**
     * Resolves a line and checks it as far as that needs no file. Never waits. Behind a line that changes the team the
     * check waits for the line's turn.
     *
     * @throws BotException if it cannot be done now
     * @throws ScriptException if it cannot be done with the robots that are there
     */
    public PreparedLine prepare(Statement statement, String text) {
        return preparation.prepare(statement, text, !queue.teamMayChange());
    }

    /** Checks the head of a block that is still being typed; throws as {@link #prepare}. */
    public void checkHead(Statement head) {
        if (!queue.teamMayChange()) {
            preparation.checkBlock(head);
        }
    }

    /** Whether a statement stops robots. */
    public boolean isStop(Statement statement) {
        return preparation.scheduling(statement) == Scheduling.STOP;
    }

    /** Waits until a line would not have to wait behind many others. */
    public void awaitRoom() throws InterruptedException {
        team.changes().await(this::hasRoom, Signal.FOR_EVER);
    }

    /** Waits until all lines have ended, with all that they began. */
    public void awaitAll() throws InterruptedException {
        team.changes().await(this::isDone, Signal.FOR_EVER);
    }

    public boolean hasRoom() {
        return queue.size() < MOST_HELD;
    }

    /** Whether all lines have ended, with all that they began. */
    public boolean isDone() {
        return queue.isEmpty()
                && adding.isEmpty()
                && beside.get() == 0
                && lines.allEnded()
                && team.areStopsAnswered()
                && team.members().stream().noneMatch(Member::isStopping);
    }

    /**
     * Runs a line at once, or queues it. Never waits. A line that names files is checked, and run, on a thread of this
     * source.
     *
     * @param refused receives the reason if a file the line names does not let it be done
     * @param failed receives the reason if the line is refused when its turn comes
     * @throws BotException if it cannot be done now; nothing happened
     * @throws ScriptException if it cannot be done with the robots that are there; nothing happened
     */
    public void submit(PreparedLine prepared, Consumer<String> refused, Consumer<String> failed) {
        SubmittedLine line = SubmittedLine.of(prepared, stops(prepared), refused, failed);
        if (goesNow(line)) {
            perform(line.asChecked(prepared.checked()), Execution.Manner.AT_ONCE);
        } else if (goesBeside(line) && !line.has(Trait.READS_FILES) && queue.isEmpty()) {
            begin(line);
        } else if (source == Source.PROMPT && queue.size() >= MOST_HELD) {
            throw new BotException("too many lines wait already (" + MOST_HELD + "); \"stop\" ends the wait");
        } else {
            queue.add(line);
        }
    }

    private boolean goesNow(SubmittedLine line) {
        Scheduling scheduling = line.scheduling();
        boolean free = queue.isEmpty() && scheduling.isQuick() && !line.has(Trait.READS_FILES);
        boolean inTurn = free && hasRoom(line) && scheduling != Scheduling.AT_ONCE_IF_TYPED;
        return switch (source) {
            case PROMPT -> free || scheduling.overtakes();
            case PIPE -> inTurn;
            case SOCKET -> scheduling == Scheduling.STOP || inTurn;
        };
    }

    /** If typed, all that takes its time runs beside the next line, except for a wait, which holds it. */
    private boolean goesBeside(SubmittedLine line) {
        return source == Source.PROMPT
                && line.scheduling() != Scheduling.HOLDS
                && !line.scheduling().isQuick();
    }

    /** Checks a line with the files that it names, which may block; empty if it was refused. */
    private Optional<SubmittedLine> checkedWithFiles(SubmittedLine line) {
        if (!line.has(Trait.READS_FILES)) {
            return Optional.of(line);
        }
        try {
            return Optional.of(line.asChecked(preparation.checkWithFiles(line.line())));
        } catch (BotException | ScriptException e) {
            line.refused().accept(String.valueOf(e.getMessage()));
        } catch (RuntimeException | Error e) {
            line.refused().accept(InternalError.report(line.title(), e));
        }
        return Optional.empty();
    }

    private boolean wasStopped(SubmittedLine line) {
        return line.has(Trait.COMMANDS_ROBOTS) && line.stops() != stops(line.line());
    }

    private boolean hasRoom(SubmittedLine line) {
        return line.line().robots().stream().allMatch(Member::hasRoom);
    }

    /** Robots that are added one after the other get their numbers in that order. */
    private void begin(SubmittedLine line) {
        if (line.scheduling() == Scheduling.BESIDE_IN_ORDER) {
            adding.add(line);
            return;
        }
        beside.incrementAndGet();
        boolean begun = team.time().tryRunAsync("script: " + line.title(), () -> {
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

    private void inTurn(SubmittedLine line) {
        if (wasStopped(line)) {
            tellStopped(line);
        } else if (line.sent()) {
            awaitFreed(line);
        } else {
            checkedWithFiles(line).ifPresent(this::takeTurn);
        }
    }

    /** Waits until the robots of a stop have stopped, and what it ended has given them back. */
    private void awaitFreed(SubmittedLine stop) {
        try {
            team.changes().await(() -> stopped(stop).stream().noneMatch(Execution::isEnding), Signal.FOR_EVER);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private List<Member> stopped(SubmittedLine stop) {
        return stop.line().statement() instanceof Statement.ForRobots line
                ? selection.present(line.robots())
                : team.members();
    }

    private void tellStopped(SubmittedLine line) {
        lines.fail(line.title());
        state.output().send(Line.Kind.ANSWER, line.title() + ": not run: stopped", asker);
    }

    private void takeTurn(SubmittedLine line) {
        if (wasStopped(line)) {
            tellStopped(line);
        } else if (goesBeside(line)) {
            begin(line);
        } else {
            attempt(line);
        }
    }

    /** Runs a line asynchronously; what goes wrong can only be reported. */
    private void attempt(SubmittedLine line) {
        try {
            perform(line, Execution.Manner.IN_TURN);
        } catch (ExecutionEnded e) {
            lines.fail(line.title());
            state.output().send(Line.Kind.ANSWER, line.title() + ": " + e.ending(), asker);
        } catch (ScriptException | BotException e) {
            line.failed().accept(String.valueOf(e.getMessage()));
        } catch (RuntimeException | Error e) {
            line.failed().accept(line.title() + ": " + InternalError.report(line.title(), e));
        }
    }

    private void perform(SubmittedLine line, Execution.Manner unlessTyped) {
        Execution execution = Execution.ofLine(
                        state, source == Source.PROMPT ? Execution.Manner.TYPED : unlessTyped, lines)
                .askedBy(asker)
                .unless(() -> wasStopped(line));
        if (line.scheduling() == Scheduling.STOP) {
            stop(line, () -> run(line, execution));
        } else if (line.line().isBlock()) {
            runBlock(line.line(), execution);
        } else {
            run(line, execution);
        }
    }

    private void run(SubmittedLine line, Execution execution) {
        Consumer<Execution> checked = line.checked();
        if (checked == null) {
            new Interpreter(execution, actions).run(List.of(line.line().statement()));
        } else {
            execution.checkAlive();
            checked.accept(execution);
        }
    }

    private void runBlock(PreparedLine block, Execution execution) {
        boolean waits = source == Source.PROMPT;
        Execution script = execution.asScript(block.title(), block.text().strip(), waits);
        if (!new ScriptRun(script, actions, block.title(), "", waits).run(List.of(block.statement()))) {
            lines.fail(block.title());
        }
    }

    /** A stop drops the lines that are held for its robots, unless it is one of the held itself and had its turn. */
    private void stop(SubmittedLine line, Runnable stopping) {
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

    private long stops(PreparedLine line) {
        return team.stops().ofOthers(line.commanded(), ownStops);
    }
}
