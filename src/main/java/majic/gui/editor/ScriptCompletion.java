package majic.gui.editor;

import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import majic.gui.completion.LineCompleter;
import majic.gui.completion.LinePlace;
import majic.script.ScriptRunner;
import majic.script.help.Completion;
import majic.script.help.Completions;
import majic.script.help.VisibleNames;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;

/**
 * Lists what a word of a script can become: while it is typed, and with Ctrl Space. Its first entry is chosen: Enter
 * and Tab take it. Must be used on the event dispatch thread.
 */
final class ScriptCompletion extends LineCompleter {
    private final RSyntaxTextArea area;
    private final ScriptRunner runner;
    private volatile VisibleNames names = VisibleNames.NONE;
    private boolean putting;

    /** Completes the words that are typed into a text. */
    ScriptCompletion(RSyntaxTextArea area, ScriptRunner runner) {
        super(area);
        this.area = area;
        this.runner = runner;
        area.getDocument().addDocumentListener(new Typing());
        area.addCaretListener(event -> {
            if (!putting) {
                caretMoved();
            }
        });
        area.addKeyListener(new Keys());
    }

    @Override
    protected Completions complete(LinePlace place) {
        return runner.complete(place.line(), place.index(), names);
    }

    /** Follows what is typed: lists words as soon as one is begun. */
    @Override
    protected void edited() {
        String before = place().before();
        if (before.isEmpty() || Character.isWhitespace(before.charAt(before.length() - 1))) {
            close();
        } else {
            list(1);
        }
    }

    /**
     * Lists the words that fit.
     *
     * @param begun how many characters of a word must be there
     */
    private void list(int begun) {
        LinePlace place = place();
        names = runner.names(area.getText(), place.number(area));
        Consumer<Completions> show = found -> show(place, found, begun);
        runner.completeVariable(names, place.line(), place.index()).ifPresentOrElse(show, () -> find(show));
    }

    /** Shows the words without hints. A word that is complete is left alone, so that Enter ends the line. */
    private void show(LinePlace place, Completions found, int begun) {
        String typed = place.before().substring(found.start());
        boolean left = !area.isEditable()
                || typed.length() < begun
                || found.words().stream().anyMatch(typed::equalsIgnoreCase);
        List<Completion> words = found.entries().stream()
                .filter(entry -> !left && !entry.isHint())
                .toList();
        show(new Completions(found.start(), words));
        move(1);
    }

    @Override
    protected void use(Completion entry) {
        LinePlace place = place();
        putting = true;
        try {
            area.replaceRange(entry.text(), place.start() + shown().start(), area.getCaretPosition());
        } finally {
            putting = false;
        }
        edited();
    }

    /** Opens the list after a character is typed, and follows every change while it is open. */
    private final class Typing implements DocumentListener {
        @Override
        public void insertUpdate(DocumentEvent event) {
            if (!putting && (event.getLength() == 1 && area.isFocusOwner() || isShowing())) {
                textChanged();
            }
        }

        @Override
        public void removeUpdate(DocumentEvent event) {
            if (!putting && isShowing()) {
                textChanged();
            }
        }

        @Override
        public void changedUpdate(DocumentEvent event) {}
    }

    /** Gives the open list its keys before the text has them. */
    private final class Keys extends KeyAdapter {
        @Override
        public void keyPressed(KeyEvent event) {
            boolean used = switch (event.getKeyCode()) {
                case KeyEvent.VK_UP, KeyEvent.VK_KP_UP -> isShowing() && moved(-1);
                case KeyEvent.VK_DOWN, KeyEvent.VK_KP_DOWN -> isShowing() && moved(1);
                case KeyEvent.VK_ENTER, KeyEvent.VK_TAB -> event.getModifiersEx() == 0 && useChosen();
                case KeyEvent.VK_SPACE -> event.isControlDown() && opened();
                case KeyEvent.VK_ESCAPE -> closed();
                default -> false;
            };
            if (used) {
                event.consume();
            }
        }

        private boolean moved(int step) {
            move(step);
            return true;
        }

        private boolean opened() {
            list(0);
            return true;
        }

        private boolean closed() {
            close();
            return true;
        }
    }
}
