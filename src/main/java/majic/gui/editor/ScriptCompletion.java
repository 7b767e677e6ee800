package majic.gui.editor;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Point;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.UIManager;
import javax.swing.text.JTextComponent;
import majic.gui.kit.CompletionCell;
import majic.gui.kit.EventThread;
import majic.script.ScriptRunner;
import majic.script.help.Completions;
import org.fife.ui.autocomplete.AbstractCompletion;
import org.fife.ui.autocomplete.AutoCompletion;
import org.fife.ui.autocomplete.Completion;
import org.fife.ui.autocomplete.CompletionProviderBase;
import org.fife.ui.autocomplete.ParameterizedCompletion;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;

/**
 * Lists what a word of a script can become: while it is typed, and with Ctrl Space. What needs files is found in the
 * background. Must be used on the event dispatch thread.
 */
final class ScriptCompletion extends CompletionProviderBase {
    private static final int DELAY_MS = 200;
    private static final int MOST_ROWS = 9;
    private static final int FRAME = 16;
    private static final int SIDES = 24;
    private static final Completions NONE = new Completions(0, List.of());

    private final RSyntaxTextArea area;
    private final ScriptRunner runner;
    private final CompletionCell cell = new CompletionCell();
    private final AutoCompletion popup = new Popup();
    private ScriptPlace found = new ScriptPlace("", 0);
    private Completions there = NONE;
    private boolean searching;

    /** A completion in the list. */
    private static final class Entry extends AbstractCompletion {
        private final majic.script.help.Completion completion;

        Entry(ScriptCompletion provider, majic.script.help.Completion completion) {
            super(provider);
            this.completion = completion;
        }

        @Override
        public String getReplacementText() {
            return completion.text();
        }

        @Override
        public String getSummary() {
            return completion.explanation();
        }
    }

    /** The list, as high as it needs to be. */
    private final class Popup extends AutoCompletion {
        Popup() {
            super(ScriptCompletion.this);
        }

        @Override
        protected int refreshPopupWindow() {
            int rows = Math.min(MOST_ROWS, getCompletions(area).size());
            cell.measure(there.entries(), UIManager.getFont("List.font"));
            Dimension row = cell.getPreferredSize();
            setChoicesWindowSize(row.width + UIScale.scale(SIDES), rows * row.height + UIScale.scale(FRAME));
            return super.refreshPopupWindow();
        }
    }

    /** Completes the words that are typed into a text. */
    ScriptCompletion(RSyntaxTextArea area, ScriptRunner runner) {
        this.area = area;
        this.runner = runner;
        setAutoActivationRules(true, "$");
        popup.setAutoActivationEnabled(true);
        popup.setAutoActivationDelay(DELAY_MS);
        popup.setAutoCompleteSingleChoices(false);
        popup.setShowDescWindow(false);
        popup.setListCellRenderer(
                (list, value, index, selected, focused) -> cell.show(((Entry) value).completion, selected));
        popup.install(area);
    }

    /** Whether the list is open. */
    boolean isOpen() {
        return popup.isPopupVisible();
    }

    private ScriptPlace place() {
        return ScriptPlace.at(area, area.getCaretPosition());
    }

    private Completions completions(ScriptPlace place) {
        if (!place.equals(found)) {
            Optional<Completions> variables = runner.completeVariable(area.getText(), place.line(), place.index());
            if (variables.isEmpty() && place.readsFiles()) {
                search(place);
                return NONE;
            }
            found = place;
            there = variables.orElseGet(() -> runner.complete(place.line(), place.index()));
        }
        return there;
    }

    private void search(ScriptPlace place) {
        if (searching) {
            return;
        }
        searching = true;
        EventThread.background(
                "completing",
                () -> {
                    Completions result = runner.complete(place.line(), place.index());
                    EventThread.later(() -> searched(place, result));
                },
                why -> searching = false);
    }

    private void searched(ScriptPlace place, Completions result) {
        searching = false;
        if (place.equals(place())) {
            found = place;
            there = result;
            popup.doCompletion();
        } else if (area.isEditable() && area.isFocusOwner()) {
            completions(place());
        }
    }

    @Override
    public String getAlreadyEnteredText(JTextComponent component) {
        ScriptPlace place = place();
        Completions now = completions(place);
        return now.entries().isEmpty() ? "" : place.line().substring(now.start(), place.index());
    }

    /** A word that is complete is left alone, so that Enter ends the line. The library adds to the list. */
    @Override
    protected List<Completion> getCompletionsImpl(JTextComponent component) {
        Completions now = completions(place());
        String typed = getAlreadyEnteredText(component);
        if (!area.isEditable() || now.words().stream().anyMatch(typed::equalsIgnoreCase)) {
            return new ArrayList<>();
        }
        return now.entries().stream()
                .filter(entry -> !entry.isHint())
                .map(entry -> new Entry(this, entry))
                .collect(Collectors.toCollection(ArrayList::new));
    }

    @Override
    public List<Completion> getCompletionsAt(JTextComponent component, Point point) {
        return List.of();
    }

    @Override
    public List<ParameterizedCompletion> getParameterizedCompletions(JTextComponent component) {
        return List.of();
    }
}
