package majic.gui.editor;

import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.Action;
import javax.swing.KeyStroke;
import majic.gui.kit.IconAction;
import majic.gui.kit.Pictogram;
import majic.script.run.ScriptControl.Progress;
import majic.text.Texts;

/** The actions of the editor's buttons and menus. */
final class EditorActions {
    private static final Texts TEXTS = Texts.of(EditorActions.class);
    final IconAction newScript;
    final IconAction open;
    final IconAction save;
    final IconAction saveAs;
    final IconAction makeAct;
    final IconAction close;
    final IconAction find;
    final IconAction run;
    final IconAction runSelection;
    final IconAction step;
    final IconAction pause;
    final IconAction end;

    EditorActions(EditorWindow window) {
        newScript = new IconAction(TEXTS.get("new"), Pictogram.NEW, TEXTS.get("new.tip"), () -> window.newScript(""))
                .withKey(KeyEvent.VK_N);
        open = new IconAction(TEXTS.get("open"), Pictogram.OPEN, TEXTS.get("open.tip"), window::chooseAndOpen)
                .withKey(KeyEvent.VK_O);
        save = new IconAction(
                        TEXTS.get("save"),
                        Pictogram.SAVE,
                        TEXTS.get("save.tip"),
                        window.onTab(tab -> tab.file().save(() -> {})))
                .withKey(KeyEvent.VK_S);
        saveAs = new IconAction(
                        TEXTS.get("saveAs"),
                        Pictogram.SAVE,
                        TEXTS.get("saveAs.tip"),
                        window.onTab(tab -> tab.file().saveAs(() -> {})))
                .withKey(KeyStroke.getKeyStroke(KeyEvent.VK_S, menuKey() | InputEvent.SHIFT_DOWN_MASK));
        makeAct = new IconAction(
                TEXTS.get("makeAct"), Pictogram.ACT, TEXTS.get("makeAct.tip"), window.onTab(window::makeAct));
        close = new IconAction(
                        TEXTS.get("close"),
                        Pictogram.QUIT,
                        TEXTS.get("close.tip"),
                        window.onTab(tab -> window.close(tab, () -> {})))
                .withKey(KeyEvent.VK_W);
        find = new IconAction(
                        TEXTS.get("find"),
                        Pictogram.FIND,
                        TEXTS.get("find.tip"),
                        window.onTab(tab -> tab.find().open()))
                .withKey(KeyEvent.VK_F);
        run = running(window, TEXTS.get("run"), Pictogram.RUN, TEXTS.get("run.tip"), TabRun::run)
                .withKey(key(KeyEvent.VK_F5, 0));
        runSelection = running(
                        window,
                        TEXTS.get("runSelection"),
                        Pictogram.RUN_SELECTION,
                        TEXTS.get("runSelection.tip"),
                        TabRun::runSelection)
                .withKey(key(KeyEvent.VK_F5, InputEvent.CTRL_DOWN_MASK));
        step = running(window, TEXTS.get("step"), Pictogram.STEP, TEXTS.get("step.tip"), TabRun::step)
                .withKey(key(KeyEvent.VK_F7, 0));
        pause = running(window, TEXTS.get("pause"), Pictogram.PAUSE, TEXTS.get("pause.tip"), TabRun::pause)
                .withKey(key(KeyEvent.VK_F6, 0));
        end = running(window, TEXTS.get("end"), Pictogram.END, TEXTS.get("end.tip"), TabRun::stop)
                .withKey(key(KeyEvent.VK_F5, InputEvent.SHIFT_DOWN_MASK));
    }

    private static IconAction running(
            EditorWindow window, String name, Pictogram icon, String tip, Consumer<TabRun> action) {
        return new IconAction(name, icon, tip, window.onTab(tab -> action.accept(tab.run())));
    }

    private static KeyStroke key(int code, int modifiers) {
        return KeyStroke.getKeyStroke(code, modifiers);
    }

    private static int menuKey() {
        return Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx();
    }

    /** Returns the actions of the buttons; the second part is about runs. */
    List<List<IconAction>> buttons() {
        return List.of(List.of(newScript, open, save), List.of(run, runSelection, step, pause, end));
    }

    /** Enables what the run of a script permits now. */
    void update(TabRun tab) {
        Progress progress = tab.progress();
        boolean running = tab.isRunning();
        run.setEnabled(!running || progress.paused());
        run.putValue(Action.NAME, running ? TEXTS.get("run.again") : TEXTS.get("run"));
        runSelection.setEnabled(!running);
        step.setEnabled(!running || progress.next().isPresent() || !progress.paused());
        pause.setEnabled(running && !progress.paused());
        end.setEnabled(running);
    }
}
