package majic.gui;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.JFrame;
import javax.swing.JMenu;
import majic.gui.editor.EditorContext;
import majic.gui.editor.EditorWindow;
import majic.gui.editor.RecentFiles;
import majic.gui.editor.RecentMenu;
import majic.gui.kit.ChooseFile;
import majic.gui.kit.ProgramServices;
import majic.script.Refusal;
import majic.script.Session;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/** Opens scripts in the script editor, which is created at its first use. */
final class FrameEditor {
    private static final Texts TEXTS = Texts.of(FrameEditor.class);

    private final JFrame frame;
    private final ProgramServices services;
    private final DroppedFiles droppedFiles;
    private final EditorContext context;
    private @Nullable EditorWindow window;

    /**
     * An editor that is not created yet.
     *
     * @param frame the window that it opens beside
     * @param stopAll stops all robots
     * @param dialogs makes acts of scripts, and opens the other files that are dropped
     * @param teams opens the saved teams that are dropped
     */
    FrameEditor(
            JFrame frame,
            Session session,
            ProgramServices services,
            Runnable stopAll,
            Function<String, Optional<Refusal>> submit,
            FrameDialogs dialogs,
            FrameTeams teams) {
        this.frame = frame;
        this.services = services;
        this.droppedFiles = new DroppedFiles(teams::open, dialogs::loadAct, dialogs::openRecording, this::open);
        this.context = new EditorContext(
                session, services.settings(), stopAll, submit, dialogs::makeActOf, droppedFiles::open);
    }

    private EditorWindow window() {
        EditorWindow there = window;
        if (there == null) {
            there = new EditorWindow(context, frame);
            window = there;
        }
        return there;
    }

    /** Opens a script that is not saved yet. */
    void newScript(String text) {
        window().newScript(text);
    }

    void chooseAndOpen() {
        ChooseFile.toOpen(frame, services.settings(), TEXTS.get("openScript.title"), ChooseFile.scripts(), this::open);
    }

    void open(Path file) {
        window().open(file);
    }

    /** Opens files that were dropped on the window, each by its kind. */
    void openDropped(List<Path> files) {
        droppedFiles.open(files);
    }

    void fillRecent(JMenu menu) {
        RecentMenu.fill(menu, new RecentFiles(services.settings(), RecentFiles.SCRIPTS), this::open);
    }

    /** Asks what to do with scripts that are not saved or that run; then does something, unless the answer is no. */
    void closeThen(Runnable then) {
        if (window == null) {
            then.run();
        } else {
            window.closeAll(then);
        }
    }

    void dispose() {
        if (window != null) {
            window.dispose();
        }
    }
}
