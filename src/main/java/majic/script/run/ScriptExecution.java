package majic.script.run;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.IntFunction;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import majic.bot.Value;
import majic.driver.Permit;
import majic.log.Line;
import majic.script.conditions.Selection;
import majic.script.record.RecordedBlock;
import majic.script.record.SessionRecord;
import majic.script.syntax.ScriptException;
import majic.team.Answer;
import majic.team.Member;
import majic.team.Owner;
import majic.team.QueuedCommand;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/**
 * One script or behaviour while it runs. A script owns the robots it commands; those of a behaviour are sublet to it.
 * The first command that fails ends it. Used by the thread that runs it; {@link #end()} may be called on any.
 */
public final class ScriptExecution extends Execution {
    private static final int MOST_FILES = 8;
    private static final String STOPPED = "stopped";

    /** How often the conditions of {@code on} are looked at, seconds. */
    private static final double WATCH_PERIOD_S = 0.05;

    private final Interpreter interpreter;
    private final Owner owner;
    private final boolean claims;
    private final Set<Member> used = new LinkedHashSet<>();
    private final SubmittedCommands own = new SubmittedCommands();
    private final @Nullable RecordedBlock block;
    private final @Nullable ScriptControl control;
    private volatile boolean ended;
    private int files;
    private ScriptControl.@Nullable Turn turn;
    private IntFunction<String> replayLine = number -> "";

    private ScriptExecution(
            Execution line, String name, RecordedBlock block, Scope<Value> names, @Nullable ScriptControl control) {
        super(line, line.origin(), line.selection(), line.wasStoppedSinceTyped());
        this.owner = new Owner(Owner.Kind.SCRIPT, name, this::end);
        this.claims = true;
        this.interpreter = new Interpreter(this, names);
        this.block = block;
        this.control = control;
        if (control != null) {
            control.begun(this::stopFromOutside);
        }
    }

    private ScriptExecution(Execution line, Owner act, Selection robots) {
        super(line, line.origin().withoutOthers(), robots, () -> false);
        this.owner = act;
        this.claims = false;
        this.interpreter = new Interpreter(this, new Scope<>());
        this.block = null;
        this.control = null;
    }

    /**
     * A script that a line begins; it owns every robot it commands.
     *
     * @param name what messages call it
     * @param text the lines that run it again
     * @param waits whether it ends only when its robots have finished
     * @param names that have values when it begins
     * @param alone whether the text does the same wherever it stands: it uses no name or procedure of other lines
     * @param control pauses and ends it; null if nothing does
     */
    public static ScriptExecution ofLine(
            Execution line,
            String name,
            String text,
            boolean waits,
            Scope<Value> names,
            boolean alone,
            @Nullable ScriptControl control) {
        RecordedBlock block = line.session().record().begin(text, waits);
        if (!alone) {
            block.dependsOnOthers();
        }
        return new ScriptExecution(line, name, block, names, control);
    }

    /**
     * A behaviour that a line runs.
     *
     * @param act the owner of its robots
     * @param robots finds the robots assigned to it
     */
    public static ScriptExecution ofAct(Execution line, Owner act, Selection robots) {
        return new ScriptExecution(line, act, robots);
    }

    @Override
    public Owner owner() {
        return owner;
    }

    @Override
    @Nullable
    SessionRecord record() {
        return block == null ? null : super.record();
    }

    @Override
    @Nullable
    RecordedBlock block() {
        return block;
    }

    /**
     * Runs a script that a line begins: claims its robots, runs, waits for them, releases them, and answers how it
     * ended. When something in it fails it ends and stops every robot that it used.
     *
     * @param title what answers call it
     * @param file where it stands; empty if it was typed
     * @param waits whether it ends, with an answer, only when its robots have finished
     * @return whether it came to its end
     */
    public boolean run(List<Statement> script, String title, String file, boolean waits) {
        long began = time().nanos();
        String how = "";
        try {
            claim(RobotsIn.of(script, selection()).commanded());
            checkAlive();
            interpreter.interpret(script);
            if (waits) {
                finish();
                how = String.format(Locale.ROOT, "done (%.1f s)", time().secondsSince(began));
                answer(title + ": " + how);
            }
            endRecord(true);
            return true;
        } catch (RuntimeException | Error e) {
            how = ending(e, title, file);
            stopAllUsed();
            endRecord(false);
            send(how.equals(STOPPED) ? Line.Kind.ANSWER : Line.Kind.FAILURE, title + ": " + how);
            return false;
        } finally {
            used.forEach(member -> member.free(owner));
            if (control != null) {
                control.ended(how);
            }
        }
    }

    /** Looks at the conditions of {@code on} while it waits. */
    @Override
    void awaitOrEnd(BooleanSupplier condition, double seconds) {
        long began = time().nanos();
        while (interpreter.watches() && !isOver() && !condition.getAsBoolean()) {
            interpreter.runDueWatches();
            double left = seconds - time().secondsSince(began);
            if (left <= 0) {
                return;
            }
            super.awaitOrEnd(condition, Math.min(left, WATCH_PERIOD_S));
        }
        super.awaitOrEnd(condition, Math.max(0, seconds - time().secondsSince(began)));
    }

    @Override
    public Scope<Value> scope() {
        return interpreter.scope();
    }

    private String ending(Throwable why, String title, String file) {
        if (why instanceof ExecutionEnded ended) {
            return ended.ending();
        }
        if (why instanceof ScriptException mistake) {
            return "failed: " + where(mistake, file);
        }
        if (why instanceof BotException) {
            return wasStopped() ? STOPPED : "failed: " + why.getMessage();
        }
        return "failed: " + InternalError.report(title, why);
    }

    /** A mistake found only now is reported like those found before the run. */
    private String where(ScriptException mistake, String file) {
        if (file.isEmpty()) {
            return String.valueOf(mistake.getMessage());
        }
        send(Line.Kind.ERROR, mistake.mistake().in(file));
        return "line " + mistake.at().line();
    }

    private void endRecord(boolean completed) {
        if (block != null) {
            super.record().end(block, completed);
        }
    }

    /** Runs a file within this script; its mistakes are reported with its name. */
    public void nested(String file, List<Statement> script) {
        if (files == MOST_FILES) {
            throw new ExecutionEnded(Answer.Outcome.FAILED, file + ": files run each other too deeply");
        }
        files++;
        try {
            interpreter.interpretFile(script);
        } catch (ScriptException e) {
            throw new ExecutionEnded(Answer.Outcome.FAILED, e.mistake().in(file));
        } finally {
            files--;
        }
    }

    @Override
    public void claim(Collection<Member> members) {
        for (Member member : members) {
            if (claims) {
                member.claim(owner);
            }
            used.add(member);
        }
    }

    @Override
    Collection<Member> allRobots() {
        return Set.copyOf(used);
    }

    /**
     * Waits until a statement may begin that begins on a line; has no effect unless the script is paused. Meanwhile no
     * block of {@code on} begins, which would take the turn of the statement. The statements of a file that the script
     * runs belong to the statement that runs the file.
     */
    void reach(int line) {
        if (control != null) {
            ScriptControl.Turn next = turn == null || files == 0 ? control.reach(line, scope().all()) : turn;
            turn = next;
            super.awaitOrEnd(next::mayBegin, Double.POSITIVE_INFINITY);
            checkAlive();
            next.enter();
        }
    }

    /** Under control a command may be held back for long, or for ever, behind the statement. */
    @Override
    boolean isRecordedWhenBegun(IntFunction<String> line) {
        replayLine = line;
        return control != null;
    }

    /** A command that is still queued when the script has ended or failed must not begin before the stop reaches it. */
    @Override
    void permit(Member member, QueuedCommand command, Permit permit) {
        if (control != null && block != null) {
            String line = replayLine.apply(member.number());
            command.checkedBy(() -> super.record().begun(line, member.number(), owner, block));
        }
        command.checkedBy(() -> {
            if (mustNotBegin()) {
                throw new MotionStopped("stopped");
            }
        });
    }

    private boolean mustNotBegin() {
        return ended || owner.isRevoked() || own.trouble().isPresent();
    }

    /**
     * Under control the thread of the robot waits, when the turn of a command has come, until the command may begin.
     */
    @Override
    void gate(Member member, QueuedCommand command) {
        if (turn == null) {
            return;
        }
        ScriptControl.GatedCommand gate = turn.command(command);
        Permit permit = member.currentPermit();
        command.checkedBy(() -> {
            awaitTurn(() -> gate.mayBegin() || permit.isRevoked() || mustNotBegin());
            gate.begin();
        });
    }

    private void awaitTurn(BooleanSupplier condition) {
        try {
            team().changes().await(condition, Signal.FOR_EVER);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new MotionStopped("stopped");
        }
    }

    @Override
    void track(Member member, QueuedCommand command) {
        super.track(member, command);
        own.add(member, command);
    }

    @Override
    public void stop(List<Member> members) {
        super.stop(members);
        await(() -> members.stream().noneMatch(Execution::isEnding), Double.POSITIVE_INFINITY);
    }

    @Override
    void forget(Collection<Member> members) {
        own.forget(members);
        super.forget(members);
    }

    /** Runs a behaviour, and waits for all its commands. */
    public void runAct(List<Statement> behaviour) {
        interpreter.interpret(behaviour);
        finish();
    }

    /** Waits for all commands of the script. */
    private void finish() {
        if (control != null) {
            control.leave();
        }
        await(own::allEnded, Double.POSITIVE_INFINITY);
    }

    /** Ends the script at the next thing it does; returns at once. */
    void end() {
        ended = true;
        team().changes().raise();
    }

    /** Stops the robots that the script has now, as a user would, and ends it. */
    private void stopFromOutside() {
        team().stop(
                        team().members().stream()
                                .filter(member -> member.owner() == owner || member.sublessor() == owner)
                                .toList(),
                        null);
        end();
    }

    /**
     * Stops the robots of a script that are still busy, except those with a pending stop and the one whose command
     * failed: it is stationary, and its queue is dropped with the reason.
     */
    private void stopAllUsed() {
        ended = true;
        long atNanos = time().nanos();
        Member failed = own.trouble().map(SubmittedCommands.Trouble::robot).orElse(null);
        Collection<Member> stopped = stopBusy(failed);
        SessionRecord record = record();
        if (record != null) {
            record.stopped(SessionRecord.numbers(stopped), atNanos, block);
        }
    }

    private Collection<Member> stopBusy(@Nullable Member exempt) {
        List<Member> busy = used.stream()
                .filter(member -> member != exempt && !member.isIdle(owner) && !member.isStopping())
                .toList();
        if (team().isLatched() || busy.isEmpty()) {
            return List.of();
        }
        team().stop(busy, owner);
        return busy;
    }

    @Override
    boolean isOver() {
        return ended || super.isOver() || own.trouble().isPresent();
    }

    @Override
    public void checkAlive() {
        if (ended) {
            throw new ExecutionEnded(Answer.Outcome.STOPPED, "stopped");
        }
        super.checkAlive();
        own.trouble().ifPresent(trouble -> {
            boolean failed = trouble.outcome() == Answer.Outcome.FAILED;
            throw failed
                    ? new ExecutionEnded(trouble.outcome(), trouble.text() + " failed")
                    : new ExecutionEnded(Answer.Outcome.STOPPED, "stopped");
        });
    }

    @Override
    boolean wasStopped() {
        return ended || super.wasStopped();
    }
}
