package majic.script.run;

import java.nio.file.Path;
import majic.script.record.SessionRecord;

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
    /**
     * Reads a script.
     *
     * @throws majic.bot.BotException if it cannot be read
     */
    static ScriptSource read(Path path) {
        return new ScriptSource(
                String.valueOf(path.getFileName()),
                path.toString(),
                "run " + SessionRecord.quoted(path.toString()),
                ScriptFiles.read(path),
                repeating(path));
    }

    /** The line that runs a file again, from any folder. */
    public static String repeating(Path path) {
        return "run " + SessionRecord.quoted(path.toAbsolutePath().toString());
    }
}
