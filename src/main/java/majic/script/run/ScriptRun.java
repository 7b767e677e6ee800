package majic.script.run;

import java.util.List;
import java.util.Locale;
import majic.bot.BotException;
import majic.log.Line;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Statement;
import majic.time.TimeSource;

/**
 * One script from its beginning to its end: claims its robots, runs, waits for them, releases them. When something in
 * it fails it ends and stops every robot that it used.
 */
public final class ScriptRun {
    private static final String STOPPED = "stopped";

    private final ScriptExecution execution;
    private final ActionLookup actions;
    private final String title;
    private final String file;
    private final boolean waits;
    private String outcome = "";

    /**
     * A run.
     *
     * @param execution the execution of the script
     * @param actions for its commands
     * @param title what answers call it
     * @param file where it stands; empty if it was typed
     * @param waits whether it ends, with an answer, only when its robots have finished
     */
    public ScriptRun(ScriptExecution execution, ActionLookup actions, String title, String file, boolean waits) {
        this.execution = execution;
        this.actions = actions;
        this.title = title;
        this.file = file;
        this.waits = waits;
    }

    /**
     * Runs it, and answers how it ended.
     *
     * @return whether it came to its end
     */
    public boolean run(List<Statement> script) {
        TimeSource time = execution.time();
        long began = time.nanos();
        try {
            execution.claim(RobotsIn.of(script, execution.selection()).commanded());
            execution.checkAlive();
            new Interpreter(execution, actions).run(script);
            if (waits) {
                execution.finish();
                answer(Line.Kind.ANSWER, String.format(Locale.ROOT, "done (%.1f s)", time.secondsSince(began)));
            }
            execution.endRecord(true);
            return true;
        } catch (RuntimeException | Error e) {
            String ending = ending(e);
            execution.stopAllUsed();
            execution.endRecord(false);
            answer(ending.equals(STOPPED) ? Line.Kind.ANSWER : Line.Kind.FAILURE, ending);
        } finally {
            execution.freeAll();
            execution.ended(outcome);
        }
        return false;
    }

    private String ending(Throwable why) {
        if (why instanceof ExecutionEnded ended) {
            return ended.ending();
        }
        if (why instanceof ScriptException mistake) {
            return "failed: " + where(mistake);
        }
        if (why instanceof BotException) {
            return execution.wasStopped() ? STOPPED : "failed: " + why.getMessage();
        }
        return "failed: " + InternalError.report(title, why);
    }

    /** A mistake found only now is reported like those found before the run. */
    private String where(ScriptException mistake) {
        if (file.isEmpty()) {
            return String.valueOf(mistake.getMessage());
        }
        execution.send(Line.Kind.ERROR, mistake.mistake().in(file));
        return "line " + mistake.at().line();
    }

    private void answer(Line.Kind kind, String how) {
        execution.send(kind, title + ": " + how);
        outcome = how;
    }
}
