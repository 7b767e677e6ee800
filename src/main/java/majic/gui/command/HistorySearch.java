package majic.gui.command;

import java.util.List;
import java.util.function.Consumer;
import majic.gui.completion.ChoicePopup;
import majic.script.help.Completion;
import majic.text.Texts;

/**
 * Searches the history for lines that contain the typed text. Enter takes the chosen line without running it; Esc
 * brings the typed text back. Must be used on the event dispatch thread.
 */
final class HistorySearch {
    private static final Texts TEXTS = Texts.of(HistorySearch.class);
    private final CommandLine line;
    private final History history;
    private final ChoicePopup popup;
    private final Consumer<String> hint;
    private String before = "";

    HistorySearch(CommandLine line, History history, ChoicePopup popup, Consumer<String> hint) {
        this.line = line;
        this.history = history;
        this.popup = popup;
        this.hint = hint;
    }

    /** Starts with the text that is in the line. */
    void start() {
        before = line.getText();
        edited();
    }

    /** Lists the lines that contain the present text. */
    void edited() {
        List<Completion> found = history.containing(line.getText()).stream()
                .map(text -> new Completion(text, "", ""))
                .toList();
        popup.show(0, found.isEmpty() ? List.of(new Completion("", "", TEXTS.get("search.none"))) : found);
        popup.choose(found.isEmpty() ? -1 : 0);
        hint.accept(TEXTS.get("search.keys"));
    }

    /** Takes a line. */
    void use(Completion entry) {
        popup.hide();
        line.put(new CompletedLine(entry.text(), entry.text().length()));
    }

    /** Brings the typed text back. */
    void cancel() {
        line.put(new CompletedLine(before, before.length()));
    }
}
