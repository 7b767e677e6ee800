package majic.script.commands;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import majic.bot.BotException;
import majic.log.Line;
import majic.script.conditions.Selection;
import majic.script.run.Checker;
import majic.script.run.Execution;
import majic.script.run.ExecutionEnded;
import majic.script.run.Scope;
import majic.script.run.ScriptControl;
import majic.script.run.ScriptExecution;
import majic.script.run.ScriptSource;
import majic.script.run.SessionState;
import majic.script.run.Statement;
import majic.script.syntax.Mistake;
import majic.team.Answer;
import org.jspecify.annotations.Nullable;

/**
 * Runs scripts from files. A file is read whole and checked before anything of it runs.
 *
 * @param session the types of its robots are words of the language
 */
public record ScriptFiles(SessionState session) {

    /**
     * Runs a file: within a script as a part of it, otherwise as a script of its own. Blocks until it has ended.
     *
     * @throws BotException if it cannot be read
     * @throws ExecutionEnded if it has mistakes, which were reported then, or ends early
     */
    public void run(Path path, Execution execution) {
        ScriptSource source = ScriptSource.read(path);
        if (execution instanceof ScriptExecution outer) {
            outer.nested(source.file(), checked(source, execution));
        } else {
            run(source, execution, null);
        }
    }

    /**
     * Runs a script of its own. Blocks until it has ended.
     *
     * @param control pauses and ends it; null if nothing does
     * @throws ExecutionEnded if it has mistakes, which were reported then
     */
    public void run(ScriptSource source, Execution execution, @Nullable ScriptControl control) {
        List<Statement> script = checked(source, execution);
        ScriptExecution alone =
                ScriptExecution.ofLine(execution, source.name(), source.replay(), true, new Scope<>(), true, control);
        if (!alone.run(script, source.title(), source.file(), true)) {
            execution.fail(source.title());
        }
    }

    /** Parses and checks a script; throws {@link ExecutionEnded} if it has mistakes, after all were reported. */
    private List<Statement> checked(ScriptSource source, Execution execution) {
        List<Mistake> mistakes = new ArrayList<>();
        List<Statement> script = checked(source.text(), execution.selection(), mistakes);
        Mistake.inOrder(mistakes, source.file()).forEach(mistake -> execution.send(Line.Kind.ERROR, mistake));
        if (!mistakes.isEmpty()) {
            throw new ExecutionEnded(
                    Answer.Outcome.FAILED, Mistake.counted(mistakes.size()) + " in it, nothing was run");
        }
        return script;
    }

    /**
     * Parses a script, and checks it against the robots that are there. Reads the files it names, so it may block.
     *
     * @param mistakes receives what is wrong
     */
    public List<Statement> checked(String text, Selection selection, List<Mistake> mistakes) {
        List<String> words = new ArrayList<>(selection.names());
        session.factory().types().forEach(type -> words.add(type.name()));
        List<Statement> script = ScriptParser.parse(text, words, mistakes);
        mistakes.addAll(Checker.check(script, session, selection));
        return script;
    }
}
