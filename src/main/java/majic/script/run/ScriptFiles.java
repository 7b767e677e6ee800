package majic.script.run;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import majic.act.RegularFile;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.log.Line;
import majic.script.record.SessionRecord;
import majic.script.syntax.Mistake;
import majic.script.syntax.ScriptParser;
import majic.script.syntax.Statement;
import majic.team.Answer;
import majic.team.BotFactory;
import majic.text.IoReason;

/**
 * Runs scripts from files. A file is read whole and checked before anything of it runs.
 *
 * @param factory its types of robots are words of the language
 * @param actions for the commands of a script
 */
public record ScriptFiles(BotFactory factory, ActionLookup actions) {
    private static final int LARGEST_BYTES = 1_000_000;

    /**
     * Runs a file: within a script as a part of it, otherwise as a script of its own. Blocks until it has ended.
     *
     * @throws BotException if it cannot be read
     * @throws ExecutionEnded if it has mistakes, which were reported then, or ends early
     */
    public void run(Path path, Execution execution) {
        String file = path.toString();
        List<Statement> script = checked(file, read(path), execution);
        if (execution instanceof ScriptExecution outer) {
            outer.nested(file, () -> new Interpreter(execution, actions).run(script));
            return;
        }
        ScriptExecution alone = execution.asScript(
                String.valueOf(path.getFileName()),
                "run " + SessionRecord.quoted(path.toAbsolutePath().toString()),
                true);
        String title = "run " + SessionRecord.quoted(file);
        if (!new ScriptRun(alone, actions, title, file, true).run(script)) {
            execution.fail(title);
        }
    }

    /** Parses and checks a script; throws {@link ExecutionEnded} if it has mistakes, after all were reported. */
    private List<Statement> checked(String file, String text, Execution execution) {
        List<Mistake> mistakes = new ArrayList<>();
        List<Statement> script = ScriptParser.parse(
                text, factory.types().stream().map(BotType::name).toList(), mistakes);
        mistakes.addAll(Checker.check(script, actions, execution.selection()));
        Mistake.inOrder(mistakes, file).forEach(mistake -> execution.send(Line.Kind.ERROR, mistake));
        if (!mistakes.isEmpty()) {
            throw new ExecutionEnded(
                    Answer.Outcome.FAILED, Mistake.counted(mistakes.size()) + " in it, nothing was run");
        }
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
