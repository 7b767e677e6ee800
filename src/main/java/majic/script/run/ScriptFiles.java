package majic.script.run;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import majic.bot.BotException;
import majic.file.RegularFile;
import majic.log.Line;
import majic.script.conditions.Selection;
import majic.script.syntax.Mistake;
import majic.script.syntax.ScriptParser;
import majic.script.syntax.Statement;
import majic.team.Answer;
import majic.team.BotFactory;
import majic.text.IoReason;
import org.jspecify.annotations.Nullable;

/**
 * Runs scripts from files. A file is read whole and checked before anything of it runs.
 *
 * @param factory its types of robots are words of the language
 * @param actions for the commands of a script
 */
public record ScriptFiles(BotFactory factory, ActionLookup actions) {
    public static final int LARGEST_BYTES = 1_000_000;

    /**
     * Runs a file: within a script as a part of it, otherwise as a script of its own. Blocks until it has ended.
     *
     * @throws BotException if it cannot be read
     * @throws ExecutionEnded if it has mistakes, which were reported then, or ends early
     */
    public void run(Path path, Execution execution) {
        ScriptSource source = ScriptSource.read(path);
        if (execution instanceof ScriptExecution outer) {
            List<Statement> script = checked(source, execution);
            outer.nested(source.file(), () -> new Interpreter(execution, actions).run(script));
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
        ScriptExecution alone = execution.asScript(source.name(), source.replay(), true, control);
        if (!alone.run(script, new Interpreter(alone, actions)::run, source.title(), source.file(), true)) {
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
        factory.types().forEach(type -> words.add(type.name()));
        List<Statement> script = ScriptParser.parse(text, words, mistakes);
        mistakes.addAll(Checker.check(script, actions, selection));
        return script;
    }

    /** The text of a file, if it may be a script. */
    public static String read(Path path) {
        try {
            byte[] bytes = RegularFile.read(path, LARGEST_BYTES + 1);
            if (bytes.length > LARGEST_BYTES) {
                throw new BotException(path + ": too long for a script, more than " + LARGEST_BYTES + " bytes");
            }
            return StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(bytes))
                    .toString();
        } catch (NoSuchFileException e) {
            throw new BotException(path + ": there is no such file", e);
        } catch (IOException e) {
            throw new BotException(path + ": cannot be read (" + IoReason.of(e) + ")", e);
        }
    }
}
