package majic.script.run;

import java.util.Collection;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.Predicate;
import majic.bot.MotionStopped;
import majic.log.Line;
import majic.script.conditions.Selection;
import majic.script.syntax.ScriptException;
import majic.team.Answer;
import majic.team.Member;
import majic.team.Owner;
import majic.team.QueuedCommand;
import majic.team.Team;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * One line or one script while it runs: its commands, its robots, whether it may go on. Used by the thread
 * that runs it; {@link #end()} comes from any.
 */
public final class Execution {
    private static final int MOST_FILES = 8;

    private final SessionState state;
    private final Team team;
    private final Selection selection;
    private final Manner manner;
    private final QueuedCommands lines;
    private final QueuedCommands own = new QueuedCommands();
    private final @Nullable Owner owner;
    private final ClaimedRobots holdings;
    private final Recording recording;
    private final long stopsBefore;
    private final boolean latchedBefore;
    private BooleanSupplier overtaken = () -> false;
    private @Nullable Object asker;
    private volatile boolean ended;
    private long motions;
    private int files;

    /** How commands are given. */
    public enum Manner {
        /** By a person: readings at once, nothing waits for room in a queue. */
        TYPED,
        /** One after the other, as in a pipe or a file. */
        IN_TURN,
        /** As {@link #IN_TURN}, by a thread that must not wait: a queue without room refuses. */
        AT_ONCE
    }

    private Execution(
            SessionState state,
            Selection selection,
            Manner manner,
            QueuedCommands lines,
            @Nullable Owner act,
            Recording recording) {
        this.state = state;
        this.team = state.team();
        this.selection = selection;
        this.manner = manner;
        this.lines = lines;
        this.owner = act;
        this.holdings = new ClaimedRobots(team, act, act != null);
        this.recording = recording;
        this.stopsBefore = team.stops().all();
        this.latchedBefore = state.team().isLatched();
    }

    private Execution(Execution line, String script, Recording recording) {
        this.state = line.state;
        this.team = line.team;
        this.selection = line.selection;
        this.manner = Manner.IN_TURN;
        this.lines = line.lines;
        this.owner = new Owner(Owner.Kind.SCRIPT, script, this::end);
        this.holdings = new ClaimedRobots(team, owner, false);
        this.recording = recording;
        this.asker = line.asker;
        this.stopsBefore = line.stopsBefore;
        this.latchedBefore = line.team.isLatched();
    }

    /** One line, which has no robot to itself and ends only by its own end. */
    public static Execution ofLine(SessionState state, Manner manner, QueuedCommands lines) {
        return new Execution(
                state, new Selection(state.team()), manner, lines, null, new Recording(state.record(), null));
    }

    /** Lets its answers carry where its lines come from. */
    public Execution askedBy(@Nullable Object source) {
        asker = source;
        return this;
    }

    public @Nullable Object asker() {
        return asker;
    }

    /** Sends an answer or another line. */
    void send(Line.Kind kind, String text) {
        state.output().send(kind, text, asker);
    }

    /** Answers the line. */
    public void answer(String text) {
        send(Line.Kind.ANSWER, text);
    }

    /** Orders nothing any more once this holds: a stop came since the line was given. */
    public Execution unless(BooleanSupplier overtakenByStop) {
        overtaken = overtakenByStop;
        return this;
    }

    /** A behaviour, with its robots on loan. */
    public static Execution ofAct(SessionState state, Owner act, Selection robots) {
        return new Execution(state, robots, Manner.IN_TURN, new QueuedCommands(), act, Recording.OFF);
    }

    /**
     * A script that this line begins, which has every robot it commands to itself.
     *
     * @param name what messages call it
     * @param text the lines that run it again
     * @param waits whether it ends only when its robots have finished
     */
    public Execution asScript(String name, String text, boolean waits) {
        return new Execution(this, name, recording.begin(text, waits));
    }

    /** Keeps what this does, for a saved session. */
    public Recording recording() {
        return recording;
    }

    /** Counts the line as not succeeded. */
    void fail(String what) {
        lines.fail(what);
    }

    /** Runs a file within this script; its mistakes are reported with its name. */
    void nested(String file, Runnable body) {
        if (files == MOST_FILES) {
            throw new ExecutionEnded(Answer.Outcome.FAILED, file + ": files run each other too deeply");
        }
        files++;
        try {
            body.run();
        } catch (ScriptException e) {
            throw new ExecutionEnded(Answer.Outcome.FAILED, e.mistake().in(file));
        } finally {
            files--;
        }
    }

    public SessionState state() {
        return state;
    }

    /** The clock of the team. */
    TimeSource time() {
        return team.time();
    }

    /** Runs a command on robots for which it was checked, and records it. */
    public void run(RobotAction action, List<Member> robots) {
        recording.run(action, robots, this);
    }

    public Selection selection() {
        return selection;
    }

    public boolean isTyped() {
        return manner == Manner.TYPED;
    }

    public boolean isScript() {
        return owner != null;
    }

    /** How many orders that move a robot were given so far. */
    long motions() {
        return motions;
    }

    /** Ends a script at the next thing it does; returns at once. */
    void end() {
        ended = true;
        team.changes().raise();
    }

    /** The owner of the robots; null for a line, which claims none. */
    public @Nullable Owner owner() {
        return owner;
    }

    /** Takes robots into a script. */
    public void claim(Collection<Member> members) {
        holdings.claim(members);
    }

    /** Submits a command to each of some robots, or to none. */
    public void submit(List<Member> members, Function<Member, QueuedCommand> commands) {
        checkAlive();
        claim(members);
        read(members, commands);
    }

    /** As {@link #submit}, for commands that only read: a script needs no robot to itself for them. */
    void read(List<Member> members, Function<Member, QueuedCommand> commands) {
        List<QueuedCommand> ready = ready(members, commands);
        if (manner == Manner.IN_TURN) {
            await(() -> members.stream().allMatch(member -> member.hasRoom(owner)), Double.POSITIVE_INFINITY);
        }
        for (int index = 0; index < ready.size(); index++) {
            members.get(index).check(ready.get(index).moves(), owner);
        }
        for (int index = 0; index < ready.size(); index++) {
            QueuedCommand command = whileAlive(ready.get(index));
            motions += command.moves() ? 1 : 0;
            members.get(index).submit(command, owner);
            track(members.get(index), command);
        }
    }

    /** Runs a command that moves nothing: beside the queue if it is typed, otherwise in its turn. */
    public void readBeside(List<Member> members, Function<Member, QueuedCommand> commands) {
        if (isTyped()) {
            runNow(members, commands);
        } else {
            read(members, commands);
        }
    }

    private List<QueuedCommand> ready(List<Member> members, Function<Member, QueuedCommand> commands) {
        return members.stream()
                .map(member -> commands.apply(member).askedBy(asker))
                .toList();
    }

    /** Runs a command beside the queue. */
    public List<QueuedCommand> runNow(List<Member> members, Function<Member, QueuedCommand> commands) {
        List<QueuedCommand> ready = ready(members, commands);
        for (int index = 0; index < ready.size(); index++) {
            members.get(index).runNow(ready.get(index));
            track(members.get(index), ready.get(index));
        }
        return ready;
    }

    /** As {@link #runNow}; in a pipe or script what follows waits for the answers. */
    public void runToEnd(List<Member> members, Function<Member, QueuedCommand> commands) {
        List<QueuedCommand> begun = runNow(members, commands);
        if (manner == Manner.IN_TURN) {
            await(() -> begun.stream().allMatch(QueuedCommand::hasEnded), Double.POSITIVE_INFINITY);
        }
    }

    private void track(Member member, QueuedCommand command) {
        lines.add(member, command);
        if (owner != null) {
            own.add(member, command);
        }
    }

    /** When a script was ended or something of it failed, what was queued elsewhere must not begin before the stop gets there. */
    private QueuedCommand whileAlive(QueuedCommand command) {
        if (owner == null) {
            return command;
        }
        return command.checkedBy(() -> {
            if (ended || owner.isDismissed() || own.trouble().isPresent()) {
                throw new MotionStopped("stopped");
            }
        });
    }

    public void stop(List<Member> members) {
        own.forget(members);
        lines.forget(members);
        team.stop(members, owner);
        if (owner != null) {
            await(() -> members.stream().noneMatch(Execution::isEnding), Double.POSITIVE_INFINITY);
        }
    }

    /** Whether a stop is on its way to a robot, or what it ended has not given the robot back yet. */
    public static boolean isEnding(Member member) {
        return member.isStopping() || member.hasDismissedOwner();
    }

    /** Waits until the commands of some kind that were submitted before have had their turn. */
    public void awaitCommands(Predicate<QueuedCommand> kind) {
        await(() -> !lines.hasOpen(kind), Double.POSITIVE_INFINITY);
    }

    /** STOP. It ends the script that contains it like all others. */
    public void stopEverything() {
        own.forget(team.members());
        lines.forget(team.members());
        team.stopAll();
    }

    /** Lets time pass. */
    public void pause(double seconds) {
        await(() -> false, seconds);
    }

    /** Waits for something, unless this has to end before. */
    void await(BooleanSupplier condition, double seconds) {
        try {
            team.changes().await(() -> condition.getAsBoolean() || isOver(), seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new ExecutionEnded(Answer.Outcome.STOPPED, "stopped");
        }
        checkAlive();
    }

    /** Waits until robots are idle and have no other owner. */
    public void awaitFinished(Collection<Member> members) {
        await(() -> members.stream().allMatch(this::isFinished), Double.POSITIVE_INFINITY);
    }

    private boolean isFinished(Member member) {
        Owner other = member.owner();
        return member.isIdle(owner) && (other == null || other == owner);
    }

    /** Waits until robots have finished their commands, unless they have another owner. */
    void awaitReadable(Collection<Member> members) {
        await(
                () -> members.stream()
                        .allMatch(
                                member -> member.isIdle(owner) || (member.owner() != null && member.owner() != owner)),
                Double.POSITIVE_INFINITY);
    }

    /** The robots that a plain {@code wait} waits for. */
    public Collection<Member> allRobots() {
        return owner == null ? team.members() : holdings.all();
    }

    /** Waits for all orders of a script. */
    public void finish() {
        await(own::allEnded, Double.POSITIVE_INFINITY);
    }

    /**
     * Stops the robots of a script that still do something; those a stop is on its way to are left alone, and so is the
     * one whose order failed: it is stationary, and its queue is dropped with the reason.
     */
    void stopAllUsed() {
        ended = true;
        long atNanos = team.time().nanos();
        Collection<Member> stopped = holdings.stopBusy(
                own.trouble().map(QueuedCommands.Trouble::robot).orElse(null));
        recording.stopped(stopped, atNanos);
    }

    /** Gives the robots of a script back. */
    void freeAll() {
        holdings.free();
    }

    public void checkAlive() {
        if (ended || team.stops().all() != stopsBefore || overtaken.getAsBoolean()) {
            throw new ExecutionEnded(Answer.Outcome.STOPPED, "stopped");
        }
        own.trouble().ifPresent(trouble -> {
            boolean failed = trouble.outcome() == Answer.Outcome.FAILED;
            throw failed
                    ? new ExecutionEnded(trouble.outcome(), trouble.text() + " failed")
                    : new ExecutionEnded(Answer.Outcome.STOPPED, "stopped");
        });
    }

    /** Whether a STOP came since this began; an order of the script may be refused before that. */
    boolean wasStopped() {
        return ended || team.stops().all() != stopsBefore || (team.isLatched() && !latchedBefore);
    }

    private boolean isOver() {
        return ended || team.stops().all() != stopsBefore || own.trouble().isPresent();
    }
}
