package majic.script.run;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.function.Predicate;
import majic.bot.Parameter;
import majic.bot.Range;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.Permit;
import majic.log.Line;
import majic.script.conditions.Selection;
import majic.script.record.RecordedBlock;
import majic.script.record.SessionRecord;
import majic.team.Answer;
import majic.team.Member;
import majic.team.Owner;
import majic.team.QueuedCommand;
import majic.team.Team;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * One line while it runs: submits its commands to the robots, waits, answers. A line owns no robot. Used by the thread
 * that runs it. Each wait blocks, and ends early with {@link ExecutionEnded} if the line or script has to end.
 */
public class Execution {
    private final Origin origin;
    private final Team team;
    private final Selection selection;
    private final Manner manner;
    private final Map<Member, Permit> permits;
    private final BooleanSupplier wasStopped;
    private final long stopsBefore;
    private final boolean latchedBefore;
    private long motions;

    /** How commands are submitted. */
    public enum Manner {
        /** Typed at a prompt: readings at once, nothing waits for room in a queue. */
        TYPED,
        /** One after the other, as in a pipe or a file. */
        IN_TURN,
        /** As {@link #IN_TURN}, by a thread that must not wait: a queue without room refuses. */
        AT_ONCE
    }

    /**
     * Where lines come from. Immutable.
     *
     * @param session what they act on
     * @param commands receives what they submit
     * @param asker what their answers carry
     * @param scope the names that the lines have given values to
     */
    public record Origin(SessionState session, SubmittedCommands commands, Object asker, Scope<Value> scope) {
        /** The same, where other commands do not count. */
        Origin withoutOthers() {
            return new Origin(session, new SubmittedCommands(), asker, scope);
        }
    }

    /**
     * A line.
     *
     * @param selection finds the robots it names
     * @param permits the permissions to move that were in force when the line was typed; for a robot without one, that
     *     in force when a command is submitted
     * @param wasStopped whether its robots were stopped since it was typed
     */
    public Execution(
            Origin origin,
            Selection selection,
            Manner manner,
            Map<Member, Permit> permits,
            BooleanSupplier wasStopped) {
        this.origin = origin;
        this.team = origin.session.team();
        this.selection = selection;
        this.manner = manner;
        this.permits = permits;
        this.wasStopped = wasStopped;
        this.stopsBefore = team.stops().all();
        this.latchedBefore = team.isLatched();
    }

    /** A script that a line begins, or a behaviour that it runs. */
    Execution(Execution line, Origin origin, Selection selection, BooleanSupplier wasStopped) {
        this.origin = origin;
        this.team = origin.session.team();
        this.selection = selection;
        this.manner = Manner.IN_TURN;
        this.permits = Map.of();
        this.wasStopped = wasStopped;
        this.stopsBefore = line.stopsBefore;
        this.latchedBefore = team.isLatched();
    }

    final Team team() {
        return team;
    }

    final Origin origin() {
        return origin;
    }

    final BooleanSupplier wasStoppedSinceTyped() {
        return wasStopped;
    }

    /** The clock of the team. */
    final TimeSource time() {
        return team.time();
    }

    /** What the lines of its session share. */
    public final SessionState session() {
        return origin.session;
    }

    /** Finds the robots that its commands name. */
    public final Selection selection() {
        return selection;
    }

    /** The names that have values here. */
    public Scope<Value> scope() {
        return origin.scope;
    }

    /**
     * Asks a person for a value, and waits for the answer.
     *
     * @param question what is asked
     * @param wanted what answers there may be
     * @param otherwise the answer if none comes in time
     * @param seconds how long to wait
     * @return the answer
     */
    public final Value ask(String question, Parameter wanted, Value otherwise, double seconds) {
        markNotRepeatable();
        Questions questions = session().questions();
        Questions.Question asked = questions.ask(question, wanted, otherwise, seconds);
        try {
            send(
                    Line.Kind.NOTICE,
                    question + " (" + answers(wanted) + "; \"answer VALUE\", or " + otherwise + " after "
                            + Value.of(seconds, Unit.S) + ")");
            await(() -> asked.answer() != null, seconds);
        } finally {
            questions.close(asked);
        }
        Value answer = asked.answer();
        if (answer == null) {
            answer(question + " no answer, " + otherwise);
            return otherwise;
        }
        return answer;
    }

    private static String answers(Parameter wanted) {
        String range = wanted.range().equals(Range.ANY) ? "" : wanted.range() + " ";
        return switch (wanted.kind()) {
            case NUMBER ->
                (range + wanted.unit().symbol()).isBlank()
                        ? "a number"
                        : (range + wanted.unit().symbol()).strip();
            case YES_NO -> "yes or no";
            case ON_OFF -> "on or off";
            case CHOICE -> String.join(", ", wanted.choices());
            case TEXT, LIST -> "a text";
        };
    }

    /** Whether its commands are submitted as typed at a prompt. */
    public final boolean isTyped() {
        return manner == Manner.TYPED;
    }

    /** Whether it belongs to a script or a behaviour. */
    public final boolean isScript() {
        return owner() != null;
    }

    /** The owner of the robots; null for a line, which owns none. */
    public @Nullable Owner owner() {
        return null;
    }

    /** Sends an answer or another line. */
    public final void send(Line.Kind kind, String text) {
        origin.session.output().send(kind, text, origin.asker);
    }

    /** Answers the line. */
    public final void answer(String text) {
        send(Line.Kind.ANSWER, text);
    }

    /** Counts the line as not succeeded. */
    public final void fail(String what) {
        origin.commands.fail(what);
    }

    /** How many commands that move a robot were submitted so far. */
    final long motions() {
        return motions;
    }

    /**
     * Whether a command is recorded for each robot when that robot begins it, instead of now.
     *
     * @param replayLine for the number of a robot, the line with which a saved session repeats it
     */
    boolean isRecordedWhenBegun(IntFunction<String> replayLine) {
        return false;
    }

    /** Where it is recorded for a saved session; null for a behaviour, since the line that runs it is recorded. */
    @Nullable
    SessionRecord record() {
        return origin.session.record();
    }

    /** The block that it belongs to in the record; null for a line. */
    @Nullable
    RecordedBlock block() {
        return null;
    }

    /** Takes notice that its text does not do the same again: it uses a random number or the answer of a person. */
    final void markNotRepeatable() {
        RecordedBlock block = block();
        if (block != null) {
            block.dependsOnOthers();
        }
    }

    /** Makes robots its own for as long as it runs; has no effect for a line. */
    public void claim(Collection<Member> members) {}

    /** Submits a command to each of some robots, or to none. */
    public final void submit(List<Member> members, Function<Member, QueuedCommand> commands) {
        List<Permit> taken = members.stream().map(this::permit).toList();
        checkAlive();
        claim(members);
        List<QueuedCommand> ready = ready(members, commands);
        for (int index = 0; index < ready.size(); index++) {
            permit(members.get(index), ready.get(index), taken.get(index));
        }
        queue(members, ready);
    }

    /** The permit is taken before the check for stops, so that a stop after that check revokes it. */
    private Permit permit(Member member) {
        Permit typed = permits.get(member);
        return typed == null ? member.currentPermit() : typed;
    }

    /** Lets a command begin, when its turn comes, only with permission. */
    void permit(Member member, QueuedCommand command, Permit permit) {
        if (command.moves()) {
            command.checkedBy(permit::check);
        }
    }

    /** Holds a command back, when its turn comes, while a script is paused. */
    void gate(Member member, QueuedCommand command) {}

    /** As {@link #submit}, for commands that only read: they need neither ownership nor permission. */
    final void read(List<Member> members, Function<Member, QueuedCommand> commands) {
        queue(members, ready(members, commands));
    }

    private void queue(List<Member> members, List<QueuedCommand> commands) {
        if (manner == Manner.IN_TURN) {
            await(() -> members.stream().allMatch(member -> member.hasRoom(owner())), Double.POSITIVE_INFINITY);
        }
        // Each is checked again when it is submitted: together they are only accepted if all are.
        for (int index = 0; commands.size() > 1 && index < commands.size(); index++) {
            members.get(index).check(commands.get(index).moves(), owner());
        }
        for (int index = 0; index < commands.size(); index++) {
            Member member = members.get(index);
            QueuedCommand command = commands.get(index);
            gate(member, command);
            motions += command.moves() ? 1 : 0;
            member.submit(command, owner());
            track(member, command);
        }
    }

    private List<QueuedCommand> ready(List<Member> members, Function<Member, QueuedCommand> commands) {
        return members.stream()
                .map(member -> commands.apply(member).askedBy(origin.asker))
                .toList();
    }

    /** Runs a command that moves nothing: beside the queue if it is typed, otherwise in its turn. */
    public final void readBeside(List<Member> members, Function<Member, QueuedCommand> commands) {
        if (isTyped()) {
            runNow(members, commands);
        } else {
            read(members, commands);
        }
    }

    /** Runs a command beside the queue. */
    public final List<QueuedCommand> runNow(List<Member> members, Function<Member, QueuedCommand> commands) {
        List<QueuedCommand> ready = ready(members, commands);
        for (int index = 0; index < ready.size(); index++) {
            members.get(index).runNow(ready.get(index));
            track(members.get(index), ready.get(index));
        }
        return ready;
    }

    /**
     * As {@link #runNow}; in a pipe or script the next command waits for the answers. If a stop ends the wait, the
     * commands are still answered, so this line is not.
     */
    public final void runToEnd(List<Member> members, Function<Member, QueuedCommand> commands) {
        List<QueuedCommand> begun = runNow(members, commands);
        if (manner == Manner.IN_TURN) {
            awaitOrEnd(() -> begun.stream().allMatch(QueuedCommand::hasEnded), Double.POSITIVE_INFINITY);
        }
    }

    void track(Member member, QueuedCommand command) {
        origin.commands.add(member, command);
    }

    /** Stops robots; that their commands end with it is not a failure. */
    public void stop(List<Member> members) {
        forget(members);
        team().stop(members, owner());
    }

    /** STOP. It ends the script that contains it like all others. Without a robot it does not latch. */
    public final void stopEverything() {
        forget(team().members());
        if (!team().stopAllIfAny()) {
            answer("stop: there is no robot to stop");
        }
    }

    void forget(Collection<Member> members) {
        origin.commands.forget(members);
    }

    /** Whether a stop of a robot is pending, or the owner that it ended has not released the robot yet. */
    public static boolean isEnding(Member member) {
        return member.isStopping() || member.isOwnerRevoked();
    }

    /** Waits for a time. */
    public final void pause(double seconds) {
        await(() -> false, seconds);
    }

    /** Waits until the commands of some kind that its source submitted before have had their turn. */
    public final void awaitCommands(Predicate<QueuedCommand> kind) {
        await(() -> !origin.commands.hasOpen(kind), Double.POSITIVE_INFINITY);
    }

    /** Waits for all robots of the line or script, and records that. */
    public final void awaitAll() {
        Collection<Member> all = allRobots();
        awaitFinished(all);
        SessionRecord record = record();
        if (record != null) {
            record.waited("wait", SessionRecord.numbers(all), block());
        }
    }

    /** Waits until robots are idle and have no other owner. */
    public final void awaitFinished(Collection<Member> members) {
        await(
                () -> members.stream().allMatch(member -> member.isIdle(owner()) && !hasOtherOwner(member)),
                Double.POSITIVE_INFINITY);
    }

    /** Waits until robots have finished their commands, unless they have another owner. */
    final void awaitReadable(Collection<Member> members) {
        await(
                () -> members.stream().allMatch(member -> member.isIdle(owner()) || hasOtherOwner(member)),
                Double.POSITIVE_INFINITY);
    }

    private boolean hasOtherOwner(Member member) {
        Owner its = member.owner();
        return its != null && its != owner();
    }

    /** The robots of the line or script. */
    Collection<Member> allRobots() {
        return team().members();
    }

    /** Waits for a condition, unless this has to end before. */
    final void await(BooleanSupplier condition, double seconds) {
        awaitOrEnd(condition, seconds);
        checkAlive();
    }

    void awaitOrEnd(BooleanSupplier condition, double seconds) {
        try {
            team().changes().await(() -> condition.getAsBoolean() || isOver(), seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new ExecutionEnded(Answer.Outcome.STOPPED, "stopped");
        }
    }

    /** Whether it has to end, looked at while it waits. */
    boolean isOver() {
        return team().stops().all() != stopsBefore;
    }

    /**
     * Checks that it may continue.
     *
     * @throws ExecutionEnded if its robots were stopped, or something in it failed
     */
    public void checkAlive() {
        if (team().stops().all() != stopsBefore || wasStopped.getAsBoolean()) {
            throw new ExecutionEnded(Answer.Outcome.STOPPED, "stopped");
        }
    }

    /** Whether a STOP came since this began; a command may be refused because of it before {@link #isOver}. */
    boolean wasStopped() {
        return team().stops().all() != stopsBefore || (team().isLatched() && !latchedBefore);
    }
}
