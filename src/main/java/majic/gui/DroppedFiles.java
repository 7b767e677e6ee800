package majic.gui;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import majic.recorder.RecordingFolder;

/**
 * Opens files that are dropped on the window or on the script editor, as the menu entry for their kind does. Immutable.
 *
 * @param team connects the robots of a saved team
 * @param act offers an act to a robot
 * @param recording replays a recording
 * @param script opens every other file in the script editor, which shows the reason if it is not a text
 */
record DroppedFiles(Consumer<Path> team, Consumer<Path> act, Consumer<Path> recording, Consumer<Path> script) {
    void open(List<Path> files) {
        files.forEach(file -> opener(file).accept(file));
    }

    private Consumer<Path> opener(Path file) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        if (name.endsWith(".team")) {
            return team;
        } else if (name.endsWith(".act")) {
            return act;
        } else if (name.endsWith(RecordingFolder.ENDING)) {
            return recording;
        }
        return script;
    }
}
