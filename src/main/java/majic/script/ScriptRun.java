package majic.script;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.script.syntax.Mistake;
import majic.script.syntax.Parser;
import majic.script.syntax.Scanner;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Statement;
import majic.team.Answer;
import majic.time.TimeSource;

/**
 * One script from its beginning to its end: takes its robots, runs, waits for them, gives them back. When something in
 * it fails it ends and stops every robot that it used.
 */
final class ScriptRun {
    private static final Pattern LINES = Pattern.compile("\\R");

    private final Execution execution;
    private final String title;
    private final String file;
    private final boolean waits;

    /**
     * A run.
     *
     * @param execution of a script
     * @param title what answers call it
     * @param file where it stands; empty if it was typed
     * @param waits whether it ends, and says so, only when its robots have finished
     */
    ScriptRun(Execution execution, String title, String file, boolean waits) {
        this.execution = execution;
        this.title = title;
        this.file = file;
        this.waits = waits;
    }

    /**
     * Reads a script.
     *
     * @throws ExecutionEnded if it has mistakes; all of them were said
     */
    static List<Statement> parse(String file, String text, Execution execution) {
        Session session = execution.session();
        List<Mistake> mistakes = new ArrayList<>();
        List<Statement> script = read(text, words(session), mistakes);
        mistakes.addAll(Checker.check(script, session, execution.selection()));
        Mistake.inOrder(mistakes, file).forEach(mistake -> execution.say(Line.Kind.ERROR, mistake));
        if (!mistakes.isEmpty()) {
            throw new ExecutionEnded(
                    Answer.Outcome.FAILED, Mistake.counted(mistakes.size()) + " in it, nothing was run");
        }
        return script;
    }

    /** Reads a script, and checks nothing that needs robots. */
    static List<Statement> read(String text, List<String> types, List<Mistake> mistakes) {
        String[] lines = LINES.split(text, -1);
        for (int index = 0; index < lines.length; index++) {
            if (lines[index].length() > MajicParser.LONGEST_LINE) {
                mistakes.add(new Mistake(index + 1, 1, MajicParser.TOO_LONG));
                return List.of();
            }
        }
        Parser parser = new Parser(Scanner.scan(text), types);
        List<Statement> script = parser.script();
        mistakes.addAll(parser.mistakes());
        return script;
    }

    static List<String> words(Session session) {
        return session.factory().types().stream().map(BotType::name).toList();
    }

    /**
     * Runs it, and says how it ended.
     *
     * @return whether it came to its end
     */
    boolean run(List<Statement> script) {
        TimeSource time = execution.session().team().time();
        long began = time.nanos();
        try {
            execution.claim(Commanded.in(script, execution.selection()));
            new Interpreter(execution).run(script);
            if (waits) {
                execution.finish();
                say(String.format(Locale.ROOT, "done (%.1f s)", time.secondsSince(began)));
            }
            execution.recording().end(true);
            return true;
        } catch (RuntimeException | Error e) {
            String ending = ending(e);
            execution.stopAllUsed();
            execution.recording().end(false);
            say(ending);
        } finally {
            execution.freeAll();
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
            return execution.wasStopped() ? "stopped" : "failed: " + why.getMessage();
        }
        return "failed: " + Mishap.told(title, why);
    }

    /** A mistake that shows only now is told as those found before anything ran are. */
    private String where(ScriptException mistake) {
        if (file.isEmpty()) {
            return String.valueOf(mistake.getMessage());
        }
        execution.say(Line.Kind.ERROR, mistake.mistake().in(file));
        return "line " + mistake.at().line();
    }

    private void say(String how) {
        execution.say(Line.Kind.ANSWER, title + ": " + how);
    }
}
