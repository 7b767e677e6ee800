package majic.gui.command;

import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import majic.gui.kit.ClosesByEsc;
import majic.gui.kit.EventThread;
import majic.script.MajicParser;
import majic.script.Refusal;

/**
 * The field where commands are typed. An accepted line is removed; a wrong one stays, is marked, and its error message
 * is shown until the line is changed. Up and Down recall earlier lines, Tab completes. The line can be edited at all
 * times: files that a line names are read on another thread, and if the line is refused because of them it is restored,
 * unless another one is being typed.
 */
public final class CommandLine extends JTextField implements ClosesByEsc {
    private static final long serialVersionUID = 1L;

    private final transient MajicParser parser;
    private final transient Consumer<String> hint;
    private final transient History history = new History();
    private final transient KeysHeldElsewhere heldKeys = new KeysHeldElsewhere(this);

    /**
     * Creates an empty line.
     *
     * @param hint shows a message, the possible completions, or an empty text
     */
    CommandLine(MajicParser parser, Consumer<String> hint) {
        this.parser = parser;
        this.hint = hint;
        setName("commandLine");
        getAccessibleContext().setAccessibleName("Command line");
        putClientProperty("JTextField.placeholderText", "a command, for instance: 1 move 500");
        putClientProperty("FlatLaf.styleClass", "monospaced");
        setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, Set.of());
        addActionListener(event -> enter());
        bind(KeyEvent.VK_UP, "older line", () -> setText(history.older(getText())));
        bind(KeyEvent.VK_DOWN, "newer line", () -> setText(history.newer(getText())));
        bind(KeyEvent.VK_TAB, "complete", this::complete);
        bind(KeyEvent.VK_ESCAPE, "unmark", this::unmark);
        getDocument().addDocumentListener(new Mending());
    }

    @Override
    public void addNotify() {
        super.addNotify();
        heldKeys.install();
    }

    @Override
    public void removeNotify() {
        heldKeys.remove();
        super.removeNotify();
    }

    private void bind(int key, String name, Runnable action) {
        getInputMap().put(KeyStroke.getKeyStroke(key, 0), name);
        getActionMap().put(name, new AbstractAction(name) {
            private static final long serialVersionUID = 1L;

            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
            }
        });
    }

    private void enter() {
        String line = getText();
        if (line.isBlank()) {
            setText("");
            return;
        }
        Optional<Refusal> wrong =
                parser.submit(line, why -> EventThread.later(() -> refusedLater(line, why.message())));
        if (wrong.isEmpty()) {
            history.add(line);
            setText("");
        } else {
            mark(wrong.get().message());
        }
    }

    /** Restores a line that was refused after its files were read; never overwrites what was typed since. */
    private void refusedLater(String line, String why) {
        if (getText().isEmpty()) {
            setText(line);
            mark(why);
        } else {
            hint.accept(why);
        }
    }

    /** Returns whether the line is marked as wrong; Esc removes the mark then. */
    @Override
    public boolean hasToClose() {
        return getClientProperty("JComponent.outline") != null;
    }

    /** Removes the mark and its message; the text stays. */
    private void unmark() {
        putClientProperty("JComponent.outline", null);
        hint.accept("");
    }

    private void mark(String why) {
        putClientProperty("JComponent.outline", "error");
        hint.accept(why);
    }

    private void complete() {
        if (getText().isBlank()) {
            transferFocus();
            return;
        }
        String text = getText();
        int caret = getCaretPosition();
        if (!MajicParser.readsFiles(text)) {
            complete(CompletedLine.complete(
                    text, caret, parser.complete(text, caret).words()));
            return;
        }
        EventThread.background("reading for the command line", () -> {
            CompletedLine done = CompletedLine.complete(
                    text, caret, parser.complete(text, caret).words());
            EventThread.later(() -> completeIfSame(text, caret, done));
        });
    }

    /** Applies the completion unless the text or the caret changed while files were read. */
    private void completeIfSame(String text, int caret, CompletedLine done) {
        if (getText().equals(text) && getCaretPosition() == caret) {
            complete(done);
        }
    }

    private void complete(CompletedLine done) {
        if (!done.text().equals(getText())) {
            setText(done.text());
        }
        setCaretPosition(done.caret());
        hint.accept(String.join("   ", done.choices()));
    }

    /** Removes the mark as soon as the line is edited. */
    private final class Mending implements DocumentListener {
        @Override
        public void insertUpdate(DocumentEvent event) {
            unmark();
        }

        @Override
        public void removeUpdate(DocumentEvent event) {
            unmark();
        }

        @Override
        public void changedUpdate(DocumentEvent event) {
            unmark();
        }
    }
}
