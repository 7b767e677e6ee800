package majic.gui.editor;

import java.awt.Window;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.SwingUtilities;
import majic.bot.BotException;
import majic.gui.editor.FileNotice.Choice;
import majic.gui.editor.ScriptFile.OnDisk;
import majic.gui.kit.ChooseFile;
import majic.gui.kit.Confirm;
import majic.gui.kit.EventThread;
import majic.text.Texts;

/**
 * The file of a tab: saves the script, and notices when another program has changed the file. All files are read and
 * written in the background. Must be used on the event dispatch thread.
 */
final class TabFile {
    private static final Texts TEXTS = Texts.of(TabFile.class);
    private final EditorTab tab;
    private final EditorContext context;
    private ScriptFile file;
    private boolean exists;
    private boolean looking;
    private OnDisk reported = OnDisk.SAME;

    /**
     * A file whose text is not shown yet.
     *
     * @param exists whether it was read, and not only named
     */
    TabFile(EditorTab tab, EditorContext context, ScriptFile file, boolean exists) {
        this.tab = tab;
        this.context = context;
        this.file = file;
        this.exists = exists;
    }

    String name() {
        return file.name();
    }

    /** Returns the file; empty if the script was never saved. */
    Optional<Path> path() {
        return exists ? Optional.of(file.path()) : Optional.empty();
    }

    /** Whether the text differs from the file. */
    boolean isModified() {
        return !tab.text().equals(file.text()) || !file.isUtf8();
    }

    /** Shows the text of the file in place of the present one. */
    void showText() {
        tab.replaceText(file.text());
        if (!file.isUtf8()) {
            tab.notice().show(TEXTS.get("latin1", file.name()));
        }
    }

    /**
     * Saves the script; asks where if it was never saved, and whether if another program has changed its file.
     *
     * @param then called once it is saved
     */
    void save(Runnable then) {
        if (!exists) {
            saveAs(then);
            return;
        }
        EventThread.background(
                "looking at a script",
                () -> {
                    boolean foreign = file.onDisk() == OnDisk.CHANGED;
                    EventThread.later(() -> save(foreign, then));
                },
                this::failed);
    }

    private void save(boolean foreign, Runnable then) {
        if (foreign) {
            Confirm.ask(window(), TEXTS.get("overwrite", file.name()), TEXTS.get("overwrite.yes"), () -> write(then));
        } else {
            write(then);
        }
    }

    private void write(Runnable then) {
        ScriptFile target = file;
        String text = tab.text();
        EventThread.background(
                "saving a script",
                () -> {
                    ScriptFile written = target.write(text);
                    EventThread.later(() -> saved(written, then));
                },
                this::failed);
    }

    /** Asks for a name and saves the script under it. */
    void saveAs(Runnable then) {
        String text = tab.text();
        String suggestion = exists ? file.path().toString() : file.name();
        ScriptFile shown = file;
        ChooseFile.toSave(
                window(),
                context.settings(),
                TEXTS.get("saveScript"),
                suggestion,
                ScriptFile::withEnding,
                path -> written(shown.at(path), text, then));
    }

    /** Writes a script, in the background; returns why it failed, empty if it did not. */
    private Optional<String> written(ScriptFile target, String text, Runnable then) {
        try {
            ScriptFile written = target.write(text);
            EventThread.later(() -> saved(written, then));
            return Optional.empty();
        } catch (BotException e) {
            return Optional.of(String.valueOf(e.getMessage()));
        }
    }

    private void saved(ScriptFile written, Runnable then) {
        file = written;
        exists = true;
        reported = OnDisk.SAME;
        tab.notice().setVisible(false);
        new RecentFiles(context.settings(), RecentFiles.SCRIPTS).add(written.path());
        tab.changed();
        then.run();
    }

    private void failed(String why) {
        tab.notice()
                .show(
                        why,
                        new Choice("saveAs", TEXTS.get("failed.saveAs"), () -> saveAs(() -> {})),
                        new Choice("close", TEXTS.get("failed.close"), () -> {}));
    }

    /** Looks in the background whether another program has changed the file, and shows a notice if so. */
    void look() {
        if (exists && !looking) {
            looking = true;
            ScriptFile known = file;
            EventThread.background(
                    "looking at a script",
                    () -> {
                        OnDisk now = known.onDisk();
                        EventThread.later(() -> looked(known, now));
                    },
                    why -> looking = false);
        }
    }

    private void looked(ScriptFile known, OnDisk now) {
        looking = false;
        if (known != file || now == reported) {
            return;
        }
        reported = now;
        switch (now) {
            case SAME -> tab.notice().setVisible(false);
            case GONE ->
                tab.notice()
                        .show(
                                TEXTS.get("gone", file.name()),
                                new Choice("saveAgain", TEXTS.get("gone.save"), () -> write(() -> {})),
                                new Choice("close", TEXTS.get("gone.close"), () -> {}));
            case CHANGED ->
                tab.notice()
                        .show(
                                TEXTS.get("changed", file.name()),
                                new Choice("loadChanged", TEXTS.get("changed.load"), this::reload),
                                new Choice("keepMine", TEXTS.get("changed.keep"), () -> {}));
        }
    }

    private void reload() {
        Path path = file.path();
        EventThread.background(
                "reading a script",
                () -> {
                    ScriptFile read = ScriptFile.read(path);
                    EventThread.later(() -> reloaded(read));
                },
                this::failed);
    }

    private void reloaded(ScriptFile read) {
        file = read;
        reported = OnDisk.SAME;
        showText();
    }

    private Window window() {
        return SwingUtilities.getWindowAncestor(tab);
    }
}
