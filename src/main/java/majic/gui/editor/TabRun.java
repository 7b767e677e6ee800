package majic.gui.editor;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import javax.swing.Timer;
import majic.script.ScriptRunner;
import majic.script.run.ScriptControl;
import majic.script.run.ScriptControl.Progress;
import majic.script.run.ScriptSource;
import org.jspecify.annotations.Nullable;

/** The run of a tab's script. The script cannot be edited while it runs. Must be used on the event dispatch thread. */
final class TabRun {
    private static final int REFRESH_MS = 50;
    private static final Progress NOT_BEGUN = new Progress(false, Set.of(), OptionalInt.empty(), List.of(), "");

    private final EditorTab tab;
    private final ScriptRunner runner;
    private final Timer refresh = new Timer(REFRESH_MS, event -> show());
    private @Nullable ScriptControl control;
    private Progress progress = NOT_BEGUN;

    TabRun(EditorTab tab, ScriptRunner runner) {
        this.tab = tab;
        this.runner = runner;
    }

    /** Returns where the script was a moment ago. */
    Progress progress() {
        return progress;
    }

    boolean isRunning() {
        return control != null && !progress.isOver();
    }

    /** Runs the script from its beginning, or goes on with one that is paused. */
    void run() {
        ScriptControl now = control;
        if (isRunning() && now != null) {
            now.resume();
            show();
        } else {
            String text = tab.text();
            boolean asSaved = !tab.file().isModified();
            Optional<Path> path = tab.file().path().filter(saved -> asSaved);
            begin("", text, path.map(ScriptSource::repeating).orElse(text.strip()), false);
        }
    }

    /** Runs the selected lines alone. */
    void runSelection() {
        if (!isRunning()) {
            ScriptArea.Lines lines = tab.area().selectedLines();
            begin(lines.title(), lines.inPlace(), lines.text().strip(), false);
        }
    }

    /** Begins the next line and pauses behind it; a script that does not run yet pauses before its first line. */
    void step() {
        ScriptControl now = control;
        if (isRunning() && now != null) {
            now.step();
            show();
        } else {
            String text = tab.text();
            begin("", text, text.strip(), true);
        }
    }

    void pause() {
        if (control != null) {
            control.pause();
            show();
        }
    }

    /** Ends the script and stops its robots. */
    void stop() {
        ScriptControl now = control;
        if (isRunning() && now != null) {
            now.end();
        }
    }

    /** Ends following the script, which may go on. */
    void close() {
        refresh.stop();
    }

    private void begin(String part, String text, String replay, boolean paused) {
        String name = tab.file().name();
        ScriptSource source = new ScriptSource(name, name, "run " + name + part, text, replay);
        tab.area().text().setEditable(false);
        control = runner.run(source, paused);
        refresh.start();
        show();
    }

    private void show() {
        ScriptControl now = control;
        if (now == null) {
            return;
        }
        Progress before = progress;
        progress = now.progress();
        tab.show(progress);
        if (progress.isOver()) {
            refresh.stop();
            tab.area().text().setEditable(true);
        }
        if (!progress.equals(before)) {
            tab.changed();
        }
    }
}
