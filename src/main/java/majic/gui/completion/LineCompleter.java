package majic.gui.completion;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.text.JTextComponent;
import majic.gui.kit.EventThread;
import majic.script.help.Completion;
import majic.script.help.Completions;
import org.jspecify.annotations.Nullable;

/**
 * Lists the completions of the word before the caret of a text. Files are read in the background, by one thread at
 * most. Closing the list, by Esc or because the text loses the focus, drops all that was asked for before, so that the
 * list does not open again by itself. Must be used on the event dispatch thread.
 */
public abstract class LineCompleter {
    protected final ChoicePopup popup;
    private final JTextComponent text;
    private Completions shown = new Completions(0, List.of());
    private boolean changePending;
    private boolean reading;
    private @Nullable Runnable next;
    private int closings;

    /**
     * Creates a completer with a closed list.
     *
     * @param text the text, in which the completer has no keys
     */
    protected LineCompleter(JTextComponent text) {
        this.text = text;
        popup = new ChoicePopup(text, this::use);
        text.addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent event) {
                close();
            }
        });
    }

    /** Finds the completions at a place; called on any thread if {@link LinePlace#readsFiles} says so. */
    protected abstract Completions complete(LinePlace place);

    /** Follows a change of the text, once the caret has moved as well. */
    protected abstract void edited();

    /** Uses an entry of the list in the text. */
    protected abstract void use(Completion entry);

    /** Returns whether the list is open. */
    public final boolean isShowing() {
        return popup.isShowing();
    }

    /** To be called after each change of the text by the user. */
    public final void textChanged() {
        if (!changePending) {
            changePending = true;
            EventThread.later(this::handleChange);
        }
    }

    private void handleChange() {
        if (changePending) {
            changePending = false;
            edited();
        }
    }

    /** To be called after each movement of the caret; closes a list that was found for another place. */
    public void caretMoved() {
        if (!changePending && isShowing()) {
            close();
        }
    }

    /**
     * Chooses the next or the previous entry.
     *
     * @param step 1 or -1
     * @return false if there is none
     */
    public final boolean move(int step) {
        return popup.move(step);
    }

    /** Uses the chosen entry; returns false if none is chosen. */
    public final boolean useChosen() {
        Optional<Completion> chosen = popup.chosen();
        chosen.ifPresent(this::use);
        return chosen.isPresent();
    }

    /** Closes the list, and drops what was asked for. */
    public void close() {
        closings++;
        changePending = false;
        next = null;
        popup.hide();
    }

    protected final LinePlace place() {
        return LinePlace.at(text, text.getCaretPosition());
    }

    /** Shows completions of the place, with none of them chosen; closes the list if there are none. */
    protected final void show(Completions found) {
        shown = found;
        popup.show(place().start() + found.start(), found.entries());
    }

    /** Returns the completions that were shown last. */
    protected final Completions shown() {
        return shown;
    }

    /** Finds completions; drops them if the list is closed, or text or caret change, until they are found. */
    protected final void find(Consumer<Completions> use) {
        LinePlace place = place();
        if (!place.readsFiles()) {
            use.accept(complete(place));
        } else if (reading) {
            next = () -> find(use);
        } else {
            reading = true;
            int asked = closings;
            EventThread.background("reading for completions", () -> read(place, asked, use), failed -> {});
        }
    }

    private void read(LinePlace place, int asked, Consumer<Completions> use) {
        Completions found = new Completions(place.index(), List.of());
        try {
            found = complete(place);
        } finally {
            Completions result = found;
            EventThread.later(() -> wasRead(place, asked, () -> use.accept(result)));
        }
    }

    private void wasRead(LinePlace place, int asked, Runnable use) {
        reading = false;
        Runnable waiting = next;
        next = null;
        if (waiting != null) {
            waiting.run();
        } else if (asked == closings && text.isFocusOwner() && place.equals(place())) {
            use.run();
        }
    }
}
