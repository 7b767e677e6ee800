package majic.gui.command;

import java.util.List;
import java.util.function.Consumer;
import majic.gui.kit.EventThread;
import majic.script.MajicParser;
import majic.script.help.Completion;
import majic.script.help.Completions;
import org.jspecify.annotations.Nullable;

/**
 * Shows the completions of the word before the caret while the line is typed. The key Tab completes as far as all of
 * them agree, and after that puts them into the line one after the other. Files are read in the background, by one
 * thread at most. Must be used on the event dispatch thread.
 */
final class LineCompleter implements PopupUse {
    private final CommandLine line;
    private final MajicParser parser;
    private final ChoicePopup popup;
    private @Nullable Cycle cycle;
    private boolean reading;
    private @Nullable Runnable next;

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

    LineCompleter(CommandLine line, MajicParser parser, ChoicePopup popup) {
        this.line = line;
        this.parser = parser;
        this.popup = popup;
    }

    @Override
    public void edited() {
        cycle = null;
        if (line.getText().isBlank()) {
            popup.hide();
        } else {
            find(found -> popup.show(found.start(), found.entries()));
        }
    }

    @Override
    public void use(Completion entry) {
        find(found -> {
            line.put(CompletedLine.with(line.getText(), found.start(), line.getCaretPosition(), entry.text()));
            edited();
        });
    }

    @Override
    public void close() {
        cycle = null;
        popup.hide();
    }

    /** Completes the word, or puts the next completion into the line. */
    void tab() {
        Cycle present = cycle;
        if (present != null && present.line().text().equals(line.getText())) {
            put(present.next());
        } else {
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
            popup.show(found.start(), found.entries());
        }
    }

    private void put(Cycle present) {
        line.put(present.line());
        popup.show(present.found().start(), present.found().entries());
        popup.highlight(present.index());
        cycle = present;
    }

    /** Finds completions; drops them if the line or the caret has changed until they are found. */
    private void find(Consumer<Completions> use) {
        String text = line.getText();
        int caret = line.getCaretPosition();
        if (!MajicParser.readsFiles(text)) {
            use.accept(parser.complete(text, caret));
        } else if (reading) {
            next = () -> find(use);
        } else {
            reading = true;
            EventThread.background("reading for the command line", () -> read(text, caret, use), failed -> {});
        }
    }

    private void read(String text, int caret, Consumer<Completions> use) {
        Completions found = new Completions(caret, List.of());
        try {
            found = parser.complete(text, caret);
        } finally {
            Completions result = found;
            EventThread.later(() -> wasRead(text, caret, () -> use.accept(result)));
        }
    }

    private void wasRead(String text, int caret, Runnable use) {
        reading = false;
        Runnable waiting = next;
        next = null;
        if (waiting != null) {
            waiting.run();
        } else if (line.isFocusOwner() && line.getText().equals(text) && line.getCaretPosition() == caret) {
            use.run();
        }
    }
}
