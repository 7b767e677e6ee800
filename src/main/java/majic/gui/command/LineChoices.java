package majic.gui.command;

import java.util.function.Consumer;
import majic.gui.completion.ChoicePopup;
import majic.gui.completion.LineCompleter;
import majic.gui.completion.LinePlace;
import majic.script.MajicParser;
import majic.script.help.Completion;
import majic.script.help.Completions;
import org.jspecify.annotations.Nullable;

/**
 * What the popup of the command line shows: completions while a line is typed, or the earlier lines of a search until
 * one is taken. The key Tab completes as far as all completions agree, and after that puts them into the line one after
 * the other. Must be used on the event dispatch thread.
 */
final class LineChoices extends LineCompleter {
    private final CommandLine line;
    private final MajicParser parser;
    private final HistorySearch search;
    private boolean searching;
    private @Nullable Cycle cycle;

    /**
     * Completions that Tab puts into the line one after the other.
     *
     * @param text the line without them
     * @param found where they belong
     * @param caret the end of the word that they replace
     * @param index the one that is in the line
     */
    private record Cycle(String text, Completions found, int caret, int index) {
        CompletedLine line() {
            return CompletedLine.put(text, found.start(), caret, found.words().get(index));
        }

        Cycle next() {
            return new Cycle(text, found, caret, (index + 1) % found.words().size());
        }
    }

    LineChoices(CommandLine line, MajicParser parser, History history, Consumer<String> hint) {
        super(line);
        this.line = line;
        this.parser = parser;
        search = new HistorySearch(line, history, popup, hint);
    }

    /** Keeps the newest messages in view while the popup is open. */
    void leaveInView(ChoicePopup.TextInView messages) {
        popup.leaveInView(messages);
    }

    /** Sets what runs whenever the popup was opened or closed. */
    void onChange(Runnable listener) {
        popup.onChange(listener);
    }

    boolean isSearching() {
        return searching;
    }

    @Override
    protected Completions complete(LinePlace place) {
        return parser.complete(place.line(), place.index());
    }

    @Override
    protected void edited() {
        cycle = null;
        if (searching) {
            search.edited();
            return;
        }
        line.dropRefused();
        if (line.getText().isBlank()) {
            popup.hide();
        } else {
            find(this::show);
        }
    }

    @Override
    protected void use(Completion entry) {
        if (searching) {
            searching = false;
            search.use(entry);
        } else {
            line.put(CompletedLine.with(line.getText(), shown().start(), line.getCaretPosition(), entry.text()));
            edited();
        }
    }

    /** Closes the completions when the caret leaves the place for which they were found. */
    @Override
    public void caretMoved() {
        if (!searching) {
            super.caretMoved();
        }
    }

    /** Closes the popup; ends a search, which brings the typed text back. */
    @Override
    public void close() {
        super.close();
        cycle = null;
        if (searching) {
            searching = false;
            search.cancel();
        }
    }

    /** Takes the line that the search has chosen; if it has found none, leaves the search with the text in the line. */
    void take() {
        if (!useChosen()) {
            searching = false;
            search.use(new Completion(line.getText(), "", ""));
        }
    }

    /** Completes the word before the caret, or puts the next completion into the line, unless a search is open. */
    void complete() {
        Cycle present = cycle;
        if (present != null && present.line().text().equals(line.getText())) {
            put(present.next());
        } else if (!searching) {
            find(this::complete);
        }
    }

    private void complete(Completions found) {
        String text = line.getText();
        int caret = line.getCaretPosition();
        CompletedLine done = CompletedLine.complete(text, found.start(), caret, found.words());
        if (!done.text().equals(text)) {
            line.put(done);
            edited();
        } else if (found.words().size() > 1) {
            put(new Cycle(text, found, caret, 0));
        } else {
            show(found);
        }
    }

    private void put(Cycle present) {
        line.put(present.line());
        show(present.found());
        popup.highlight(present.index());
        cycle = present;
    }

    /** Starts a search with the text of the line, or goes on to the next line found. */
    void searchOrNext() {
        if (searching) {
            move(1);
        } else {
            close();
            searching = true;
            search.start();
        }
    }
}
