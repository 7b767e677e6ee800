package majic.gui.command;

import java.util.Optional;
import java.util.function.Consumer;
import majic.script.MajicParser;
import majic.script.help.Completion;

/**
 * What the popup of the command line shows: completions while a line is typed, or the earlier lines of a search until
 * one is taken. Must be used on the event dispatch thread.
 */
final class LineChoices {
    private final ChoicePopup popup;
    private final LineCompleter completer;
    private final HistorySearch search;
    private PopupUse present;

    LineChoices(CommandLine line, MajicParser parser, History history, Consumer<String> hint) {
        popup = new ChoicePopup(line, this::use);
        completer = new LineCompleter(line, parser, popup);
        search = new HistorySearch(line, history, popup, hint);
        present = completer;
    }

    /** Keeps the newest messages in view while the popup is open. */
    void leaveInView(MessageArea messages) {
        popup.leaveInView(messages);
    }

    boolean isShowing() {
        return popup.isShowing();
    }

    boolean isSearching() {
        return present == search;
    }

    /**
     * Chooses the next or the previous entry.
     *
     * @param step 1 or -1
     * @return false if there is none
     */
    boolean move(int step) {
        return popup.move(step);
    }

    /** Uses the chosen entry; returns false if none is chosen. */
    boolean useChosen() {
        Optional<Completion> chosen = popup.chosen();
        chosen.ifPresent(this::use);
        return chosen.isPresent();
    }

    private void use(Completion entry) {
        PopupUse used = present;
        present = completer;
        used.use(entry);
    }

    /** Completes the word before the caret, unless earlier lines are searched. */
    void complete() {
        if (!isSearching()) {
            completer.tab();
        }
    }

    /** Starts a search with the text of the line, or goes on to the next line found. */
    void searchOrNext() {
        if (isSearching()) {
            popup.move(1);
        } else {
            completer.close();
            present = search;
            search.start();
        }
    }

    /** Follows a change of the line. */
    void edited() {
        present.edited();
    }

    /** Closes the completions when the caret leaves the place for which they were found. */
    void caretMoved() {
        if (!isSearching() && popup.isShowing()) {
            completer.close();
        }
    }

    /** Hides the popup; ends a search, which brings the typed text back. */
    void close() {
        PopupUse closed = present;
        present = completer;
        closed.close();
    }
}
