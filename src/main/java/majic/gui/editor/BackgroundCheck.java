package majic.gui.editor;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.Timer;
import majic.gui.kit.EventThread;
import majic.script.ScriptRunner;
import majic.script.ScriptRunner.Checked;
import majic.script.syntax.Mistake;

/** Checks a script in the background, soon after each change of it. Must be used on the event dispatch thread. */
final class BackgroundCheck {
    private static final int DELAY_MS = 300;

    private final ScriptRunner runner;
    private final Supplier<String> text;
    private final Consumer<Checked> found;
    private final Timer delay = new Timer(DELAY_MS, event -> begin());
    private boolean running;

    /**
     * Creates a check that has nothing to do yet.
     *
     * @param text returns the script as it is now
     * @param found receives the result, unless the script has changed meanwhile
     */
    BackgroundCheck(ScriptRunner runner, Supplier<String> text, Consumer<Checked> found) {
        this.runner = runner;
        this.text = text;
        this.found = found;
        delay.setRepeats(false);
    }

    /** Checks the script once it has not changed for a while. */
    void soon() {
        delay.restart();
    }

    /** Checks the script as it is. */
    void now() {
        delay.stop();
        begin();
    }

    private void begin() {
        if (running) {
            soon();
            return;
        }
        running = true;
        String checked = text.get();
        EventThread.background(
                "checking a script",
                () -> {
                    Checked result = runner.check(checked);
                    EventThread.later(() -> ended(checked, result));
                },
                why -> ended(checked, new Checked(List.of(new Mistake(1, 1, why)), List.of())));
    }

    private void ended(String checked, Checked result) {
        running = false;
        if (checked.equals(text.get())) {
            found.accept(result);
        } else {
            soon();
        }
    }
}
