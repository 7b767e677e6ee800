package majic.gui.editor;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import majic.environment.Settings;
import majic.script.Session;

/**
 * What the main window provides to the editor. Immutable.
 *
 * @param session runs the scripts
 * @param settings stores the recent files and the folder of the file dialogs
 * @param stopAll stops all robots
 * @param makeAct opens the dialog that makes an act's file of a script
 * @param dropped opens files that are dropped on the editor, each by its kind
 */
public record EditorContext(
        Session session, Settings settings, Runnable stopAll, Consumer<Path> makeAct, Consumer<List<Path>> dropped) {}
