package majic.gui.editor;

import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.Action;
import javax.swing.KeyStroke;
import majic.gui.kit.IconAction;
import majic.script.run.ScriptControl.Progress;

/** The actions of the editor's buttons and menus. */
final class EditorActions {
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
        newScript = new IconAction("New", "new", "Begin a new script", window::newScript).withKey(KeyEvent.VK_N);
        open = new IconAction("Open…", "open", "Open a script or a saved session", window::chooseAndOpen)
                .withKey(KeyEvent.VK_O);
        save = new IconAction(
                        "Save",
                        "save",
                        "Save the script",
                        window.onTab(tab -> tab.file().save(() -> {})))
                .withKey(KeyEvent.VK_S);
        saveAs = new IconAction(
                        "Save as…",
                        "save",
                        "Save the script under another name",
                        window.onTab(tab -> tab.file().saveAs(() -> {})))
                .withKey(KeyStroke.getKeyStroke(KeyEvent.VK_S, menuKey() | InputEvent.SHIFT_DOWN_MASK));
        makeAct = new IconAction("Make Act…", "act", "Make an act of the script", window.onTab(window::makeAct));
        close = new IconAction("Close", "quit", "Close the script", window.onTab(tab -> window.close(tab, () -> {})))
                .withKey(KeyEvent.VK_W);
        find = new IconAction(
                        "Find…",
                        "find",
                        "Find a text in the script",
                        window.onTab(tab -> tab.find().open()))
                .withKey(KeyEvent.VK_F);
        run = running(window, "Run", "run", "Run the script, or go on after a pause", TabRun::run)
                .withKey(key(KeyEvent.VK_F5, 0));
        runSelection = running(
                        window, "Run selection", "run-selection", "Run the selected lines alone", TabRun::runSelection)
                .withKey(key(KeyEvent.VK_F5, InputEvent.CTRL_DOWN_MASK));
        step = running(window, "Step", "step", "Run one line and pause behind it", TabRun::step)
                .withKey(key(KeyEvent.VK_F7, 0));
        pause = running(window, "Pause", "pause", "Begin no further line; what moves goes on to its end", TabRun::pause)
                .withKey(key(KeyEvent.VK_F6, 0));
        end = running(window, "End", "end", "Stop the robots of the script and end it", TabRun::stop)
                .withKey(key(KeyEvent.VK_F5, InputEvent.SHIFT_DOWN_MASK));
    }

    private static IconAction running(
            EditorWindow window, String name, String icon, String tip, Consumer<TabRun> action) {
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
        run.putValue(Action.NAME, running ? "Go on" : "Run");
        runSelection.setEnabled(!running);
        step.setEnabled(!running || progress.next().isPresent() || !progress.paused());
        pause.setEnabled(running && !progress.paused());
        end.setEnabled(running);
    }
}
