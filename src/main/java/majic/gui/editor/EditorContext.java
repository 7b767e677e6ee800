package majic.gui.editor;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import majic.environment.Settings;
import majic.script.Refusal;
import majic.script.Session;

/**
 * What the main window provides to the editor. Immutable.
 *
 * @param session runs the scripts
 * @param settings stores the recent files and the folder of the file dialogs
 * @param stopAll stops all robots
 * @param makeAct opens the dialog that makes an act's file of a script
 * @param submit submits a line as if it were typed on the command line; returns why it is refused, if it is
 * @param dropped opens files that are dropped on the editor, each by its kind
 */
public record EditorContext(
        Session session,
        Settings settings,
        Runnable stopAll,
        Function<String, Optional<Refusal>> submit,
        Consumer<Path> makeAct,
        Consumer<List<Path>> dropped) {}
