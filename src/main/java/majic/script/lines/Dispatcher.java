package majic.script.lines;

import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.bot.Value;
import majic.driver.Permit;
import majic.log.Line;
import majic.log.SessionOutput;
import majic.script.conditions.Selection;
import majic.script.run.CommandTrait;
import majic.script.run.Execution;
import majic.script.run.ExecutionEnded;
import majic.script.run.InternalError;
import majic.script.run.Scheduling;
import majic.script.run.Scope;
import majic.script.run.SessionState;
import majic.script.run.Statement;
import majic.script.run.SubmittedCommands;
import majic.script.syntax.Operand;
import majic.script.syntax.ScriptException;
import majic.team.Answer;
import majic.team.Member;
import majic.team.StopCount;
import majic.team.Team;
import majic.time.Signal;

/** Runs prepared lines: at once on the caller's thread, beside it, or in their turn. Thread-safe. */
public final class Dispatcher {
    /** How many typed lines may wait behind a {@code wait}. */
    static final int MOST_WAITING = 100;

    private static final String NOT_RUN = "not run: stopped";

    private final SessionState session;
    private final Team team;
    private final SessionOutput output;
    private final LineSource source;
    private final Object asker;
    private final Selection selection;
    private final SubmittedCommands commands = new SubmittedCommands();
    private final Execution.Origin origin;
    private final LineQueue queue;
    private final LineQueue adding;
    private final AtomicInteger beside = new AtomicInteger();
    private final StopCount ownStops = new StopCount();

    /**
     * A dispatcher without lines.
     *
     * @param asker what the answers to its lines carry
     */
    public Dispatcher(SessionState session, LineSource source, Object asker) {
        this.asker = asker;
        this.session = session;
        this.team = session.team();
        this.output = session.output();
        this.source = source;
        this.selection = new Selection(team);
        this.origin = new Execution.Origin(session, commands, asker, new Scope<>());
        this.queue = new LineQueue(team, "script lines", this::inTurn);
        this.adding = new LineQueue(team, "adding robots", this::runInTurn);
    }

    /** The names that the lines have given values to. */
    public Scope<Value> names() {
        return origin.scope();
    }

    /** What all lines have submitted so far, and whether one failed. */
    public SubmittedCommands commands() {
        return commands;
    }

    /**
     * Resolves a line, takes the permissions to move its robots, and checks it as far as that needs no file. Never
     * waits. Behind a line that changes the team the check waits for the line's turn.
     *
     * @param names what is known of the names that it may use; a name that it makes is added
     * @throws BotException if it cannot be done now
     * @throws ScriptException if it cannot be done with the robots that are there
     */
    public PreparedLine prepare(Statement statement, String text, Scope<Operand> names) {
        boolean check = !queue.teamMayChange();
        PreparedLine line = PreparedLine.of(statement, text, session, selection, names, check);
        line.typedAfter(stops(line));
        if (check) {
            line.check();
        }
        return line;
    }

    /** Checks the head of a block that is still being typed; throws as {@link #prepare}. */
    public void checkHead(Statement head, Scope<Operand> names) {
        prepare(head, "", names);
    }

    /** Whether a statement stops robots. */
    public static boolean isStop(Statement statement) {
        return statement.scheduling() == Scheduling.STOP;
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
        return queue.size() < MOST_WAITING;
    }

    /** Whether all lines have ended, with all that they began. */
    public boolean isDone() {
        return queue.isEmpty()
                && adding.isEmpty()
                && beside.get() == 0
                && commands.allEnded()
                && team.areStopsAnswered()
                && team.members().stream().noneMatch(Member::isStopping);
    }

    /**
     * Runs a line at once, or queues it. Never waits. A line that names files is checked, and run, on a thread of this
     * origin.
     *
     * @param refused receives a {@link BotException}, or a {@link ScriptException} with the place, if a file that the
     *     line names does not let it be done
     * @param failed receives the reason if the line is refused when its turn comes
     * @throws BotException if it cannot be done now; nothing happened
     * @throws ScriptException if it cannot be done with the robots that are there; nothing happened
     */
    public void submit(PreparedLine line, Consumer<RuntimeException> refused, Consumer<String> failed) {
        line.reportTo(refused, failed);
        if (runsNow(line)) {
            runAtOnce(line);
        } else if (runsBeside(line) && !line.has(CommandTrait.READS_FILES) && queue.isEmpty()) {
            line.waits();
            begin(line);
        } else if (source == LineSource.PROMPT && !hasRoom()) {
            throw new BotException("too many lines wait already (" + MOST_WAITING + "); \"stop\" ends the wait");
        } else {
            line.waits();
            queue.add(line);
        }
    }

    /** Whether the caller's thread runs the line, which it can if no line waits and no robot has to be waited for. */
    private boolean runsNow(PreparedLine line) {
        boolean typed = source == LineSource.PROMPT;
        boolean free = queue.isEmpty() && !line.has(CommandTrait.READS_FILES);
        return switch (line.scheduling()) {
            case STOP -> source != LineSource.PIPE || (free && robotsHaveRoom(line));
            case OVERTAKES -> typed || (free && robotsHaveRoom(line));
            case ANSWERS -> free || source != LineSource.PIPE;
            case AT_ONCE -> free && (typed || robotsHaveRoom(line));
            case AT_ONCE_IF_TYPED -> free && typed;
            case BESIDE, BESIDE_IN_ORDER, HOLDS -> false;
        };
    }

    private static boolean robotsHaveRoom(PreparedLine line) {
        return line.robots().stream().allMatch(Member::hasRoom);
    }

    /** Whether the lines behind it do not wait for it: if it was typed, unless it is a {@code wait}. */
    private boolean runsBeside(PreparedLine line) {
        return source == LineSource.PROMPT
                && switch (line.scheduling()) {
                    case BESIDE, BESIDE_IN_ORDER -> true;
                    case STOP, OVERTAKES, ANSWERS, AT_ONCE, AT_ONCE_IF_TYPED, HOLDS -> false;
                };
    }

    /**
     * Starts a line beside the others. Robots that are added one after the other get their numbers in that order. A
     * line that reads robots first may wait long before it moves one, so a stop of the same source revokes it too; a
     * block owns its robots, and the stop ends that.
     */
    private void begin(PreparedLine line) {
        if (line.scheduling() == Scheduling.BESIDE_IN_ORDER) {
            adding.add(line);
            return;
        }
        beside.incrementAndGet();
        long stops = team.stops().of(line.commanded());
        Execution execution = line.isBlock()
                ? execution(line, Execution.Manner.IN_TURN, Map.of())
                : execution(
                        Execution.Manner.IN_TURN,
                        Map.of(),
                        () -> line.has(CommandTrait.COMMANDS_ROBOTS)
                                && team.stops().of(line.commanded()) != stops);
        boolean begun = team.time().tryRunAsync("script: " + line.title(), () -> {
            try {
                runBeside(line, execution, stops);
            } finally {
                ended();
            }
        });
        if (!begun) {
            ended();
            line.fail(line.title() + ": the system has no thread left for it; end an act or a program");
        }
    }

    /** A stop may have come before the thread of the line runs, also one of the same source, which was given later. */
    private void runBeside(PreparedLine line, Execution execution, long stopsBefore) {
        if (line.has(CommandTrait.COMMANDS_ROBOTS) && team.stops().of(line.commanded()) != stopsBefore) {
            fail(line, Line.Kind.ANSWER, NOT_RUN);
        } else {
            runInTurn(line, execution);
        }
    }

    private void ended() {
        beside.decrementAndGet();
        team.changes().raise();
    }

    /** Runs a line whose turn has come. */
    private void inTurn(PreparedLine line) {
        if (wasStopped(line)) {
            fail(line, Line.Kind.ANSWER, NOT_RUN);
        } else if (line.isStopSent()) {
            awaitFreed(line);
        } else if (filesAllow(line)) {
            inTurnWithFiles(line);
        }
    }

    /** Reading the files may have taken long, so a stop may have come meanwhile. */
    private void inTurnWithFiles(PreparedLine line) {
        if (wasStopped(line)) {
            fail(line, Line.Kind.ANSWER, NOT_RUN);
        } else if (runsBeside(line)) {
            begin(line);
        } else {
            runInTurn(line);
        }
    }

    /** Whether the files that a line names let it be done; if not, reports that. Reads them, so it may block. */
    private boolean filesAllow(PreparedLine line) {
        try {
            if (line.has(CommandTrait.READS_FILES)) {
                line.checkWithFiles();
            }
            return true;
        } catch (BotException | ScriptException e) {
            line.refuse(e);
        } catch (RuntimeException | Error e) {
            line.refuse(new BotException(InternalError.report(line.title(), e)));
        }
        return false;
    }

    private boolean wasStopped(PreparedLine line) {
        return line.has(CommandTrait.COMMANDS_ROBOTS) && line.stopsBefore() != stops(line);
    }

    private long stops(PreparedLine line) {
        return team.stops().ofOthers(line.commanded(), ownStops);
    }

    /** Runs a line on the caller's thread. */
    private void runAtOnce(PreparedLine line) {
        try {
            Execution execution = execution(line, Execution.Manner.AT_ONCE, line.permits());
            perform(line, () -> line.run(execution));
        } catch (ExecutionEnded e) {
            answerEnded(line, e);
        }
    }

    /** What ends early has submitted nothing if it commands robots; a wait has begun. */
    private void answerEnded(PreparedLine line, ExecutionEnded end) {
        boolean stopped = end.outcome() == Answer.Outcome.STOPPED;
        boolean notRun = stopped && line.has(CommandTrait.COMMANDS_ROBOTS);
        fail(line, stopped ? Line.Kind.ANSWER : Line.Kind.FAILURE, notRun ? NOT_RUN : end.ending());
    }

    private void fail(PreparedLine line, Line.Kind kind, String how) {
        commands.fail(line.title());
        output.send(kind, line.title() + ": " + how, asker);
    }

    /** Runs a line asynchronously; errors can only be reported. Permissions to move are taken as they are now. */
    private void runInTurn(PreparedLine line) {
        runInTurn(line, execution(line, Execution.Manner.IN_TURN, Map.of()));
    }

    private void runInTurn(PreparedLine line, Execution execution) {
        try {
            perform(line, () -> line.run(execution));
        } catch (ExecutionEnded e) {
            answerEnded(line, e);
        } catch (ScriptException | BotException e) {
            line.fail(String.valueOf(e.getMessage()));
        } catch (RuntimeException | Error e) {
            line.fail(line.title() + ": " + InternalError.report(line.title(), e));
        }
    }

    private Execution execution(PreparedLine line, Execution.Manner unlessTyped, Map<Member, Permit> permits) {
        return execution(unlessTyped, permits, () -> wasStopped(line));
    }

    private Execution execution(Execution.Manner unlessTyped, Map<Member, Permit> permits, BooleanSupplier wasStopped) {
        Execution.Manner manner = source == LineSource.PROMPT ? Execution.Manner.TYPED : unlessTyped;
        return new Execution(origin, selection, manner, permits, wasStopped);
    }

    /** Runs a line, after what a stop needs first. */
    private void perform(PreparedLine line, Runnable run) {
        if (line.scheduling() == Scheduling.STOP) {
            stop(line, run);
        } else {
            run.run();
        }
    }

    /** A stop drops the lines that wait for its robots, unless it waited itself and has its turn now. */
    private void stop(PreparedLine line, Runnable run) {
        if (queue.isEmpty() || queue.isCurrent(line)) {
            ownStops.during(run);
        } else {
            run.run();
        }
        if (queue.isCurrent(line)) {
            awaitFreed(line);
        } else if (source != LineSource.PROMPT) {
            line.markStopSent();
            queue.add(line);
        }
    }

    /** Waits until the robots of a stop have stopped, and the owners that it ended have released them. */
    private void awaitFreed(PreparedLine stop) {
        List<Member> stopped = stop.robots().isEmpty() ? team.members() : stop.robots();
        try {
            team.changes().await(() -> stopped.stream().noneMatch(Execution::isEnding), Signal.FOR_EVER);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
