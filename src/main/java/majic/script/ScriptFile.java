package majic.script;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import majic.act.RegularFile;
import majic.bot.BotException;
import majic.bot.IoReason;
import majic.script.syntax.Statement;

/** A script in a file: read whole and checked before anything of it runs. */
final class ScriptFile {
    private static final int LARGEST_BYTES = 1_000_000;

    private ScriptFile() {}

    /**
     * Runs a file: within a script as a part of it, otherwise as a script of its own. Blocks until it has ended.
     *
     * @throws BotException if it cannot be read
     * @throws ExecutionEnded if it has mistakes, which were said then, or ends before its time
     */
    static void run(Path path, Execution execution) {
        String file = path.toString();
        List<Statement> script = ScriptRun.parse(file, read(path), execution);
        if (execution.isScript()) {
            execution.nested(file, () -> new Interpreter(execution).run(script));
            return;
        }
        Execution alone = execution.asScript(String.valueOf(path.getFileName()), ReplayWording.run(path), true);
        String title = "run " + SessionRecord.quoted(file);
        if (!new ScriptRun(alone, title, file, true).run(script)) {
            execution.fail(title);
        }
    }

    /** The text of a file, if it may be a script. */
    static String read(Path path) {
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
