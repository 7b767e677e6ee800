package majic.script.run;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import majic.bot.BotException;
import majic.file.RegularFile;
import majic.script.record.SessionRecord;
import majic.text.IoReason;

/**
 * A script to run. Immutable.
 *
 * @param name what the messages about its robots call it: {@code lap.majic}
 * @param file what the messages about its mistakes call it
 * @param title what its answers call it: {@code run lap.majic}
 * @param text the script
 * @param replay the lines with which a saved session repeats it
 */
public record ScriptSource(String name, String file, String title, String text, String replay) {
    /** The size of the largest file that is read as a script, bytes. */
    public static final int LARGEST_BYTES = 1_000_000;

    /**
     * Reads a script.
     *
     * @throws BotException if it cannot be read
     */
    public static ScriptSource read(Path path) {
        return new ScriptSource(
                String.valueOf(path.getFileName()),
                path.toString(),
                "run " + SessionRecord.quoted(path.toString()),
                textOf(path),
                repeating(path));
    }

    /**
     * The text of a file, if it may be a script.
     *
     * @throws BotException if it cannot be read
     */
    public static String textOf(Path path) {
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

    /** The line that runs a file again, from any folder. */
    public static String repeating(Path path) {
        return "run " + SessionRecord.quoted(path.toAbsolutePath().toString());
    }
}
