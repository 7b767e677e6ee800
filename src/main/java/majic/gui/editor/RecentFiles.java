package majic.gui.editor;

import java.lang.System.Logger.Level;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import majic.bot.BotException;
import majic.environment.Settings;
import majic.gui.kit.EventThread;

/**
 * The files of a kind that were opened or saved last, kept in the settings. Must be used on the event dispatch thread.
 */
public final class RecentFiles {
    /** The setting that has the scripts. */
    public static final String SCRIPTS = "editor.recent";

    /** The setting that has the maps. */
    public static final String MAPS = "map.recent";

    private static final int MOST = 10;

    private final Settings settings;
    private final String key;

    /**
     * The files of a kind.
     *
     * @param key the setting that has them
     */
    public RecentFiles(Settings settings, String key) {
        this.settings = settings;
        this.key = key;
    }

    /** Returns the files, the latest first. */
    public List<Path> list() {
        List<Path> files = new ArrayList<>();
        for (String line : settings.get(key).orElse("").split("\n")) {
            try {
                if (!line.isEmpty()) {
                    files.add(Path.of(line));
                }
            } catch (InvalidPathException e) {
                continue;
            }
        }
        return files;
    }

    /** Puts a file at the beginning of the list. */
    public void add(Path file) {
        List<Path> files = list();
        files.remove(file);
        files.add(0, file);
        store(files.subList(0, Math.min(MOST, files.size())));
    }

    /** Removes a file that is no longer there. */
    void remove(Path file) {
        List<Path> files = list();
        if (files.remove(file)) {
            store(files);
        }
    }

    private void store(List<Path> files) {
        String text = String.join("\n", files.stream().map(Path::toString).toList());
        EventThread.background("remembering recent files", () -> store(text));
    }

    private void store(String text) {
        try {
            settings.put(key, text);
        } catch (BotException e) {
            System.getLogger(RecentFiles.class.getName())
                    .log(Level.DEBUG, "recent files are not remembered after the end", e);
        }
    }
}
