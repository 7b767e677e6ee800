package majic.gui.editor;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Point;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.text.JTextComponent;
import majic.gui.kit.EventThread;
import majic.script.MajicParser;
import majic.script.ScriptRunner;
import majic.script.help.Completions;
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
    private static final int WIDTH = 720;
    private static final int MOST_ROWS = 9;
    private static final int FRAME = 16;
    private static final Completions NONE = new Completions(0, List.of());

    private final RSyntaxTextArea area;
    private final ScriptRunner runner;
    private final CompletionCell cell = new CompletionCell();
    private final AutoCompletion popup = new Popup();
    private Place found = new Place("", 0);
    private Completions there = NONE;
    private boolean searching;

    /**
     * A place in a line.
     *
     * @param caret 0 to the length of the line
     */
    private record Place(String line, int caret) {
        boolean readsFiles() {
            return MajicParser.readsFiles(line.substring(0, caret));
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
            setChoicesWindowSize(UIScale.scale(WIDTH), rows * cell.getPreferredSize().height + UIScale.scale(FRAME));
            return super.refreshPopupWindow();
        }
    }

    /** Completes the words that are typed into a text. */
    ScriptCompletion(RSyntaxTextArea area, ScriptRunner runner) {
        this.area = area;
        this.runner = runner;
        setAutoActivationRules(true, "");
        popup.setAutoActivationEnabled(true);
        popup.setAutoActivationDelay(DELAY_MS);
        popup.setAutoCompleteSingleChoices(false);
        popup.setShowDescWindow(false);
        popup.setListCellRenderer(cell);
        popup.install(area);
    }

    /** Whether the list is open. */
    boolean isOpen() {
        return popup.isPopupVisible();
    }

    private Place place() {
        int start = area.getLineStartOffsetOfCurrentLine();
        String line = area.getText().substring(start, Math.max(start, area.getLineEndOffsetOfCurrentLine()));
        String withoutEnd = line.endsWith("\n") ? line.substring(0, line.length() - 1) : line;
        return new Place(withoutEnd, Math.min(withoutEnd.length(), area.getCaretOffsetFromLineStart()));
    }

    private Completions completions(Place place) {
        if (!place.equals(found)) {
            if (place.readsFiles()) {
                search(place);
                return NONE;
            }
            found = place;
            there = runner.complete(place.line(), place.caret());
        }
        return there;
    }

    private void search(Place place) {
        if (searching) {
            return;
        }
        searching = true;
        EventThread.background(
                "completing",
                () -> {
                    Completions result = runner.complete(place.line(), place.caret());
                    EventThread.later(() -> searched(place, result));
                },
                why -> searching = false);
    }

    private void searched(Place place, Completions result) {
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
        Place place = place();
        Completions now = completions(place);
        return now.entries().isEmpty() ? "" : place.line().substring(now.start(), place.caret());
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
                .map(entry -> new CompletionCell.Entry(this, entry))
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
