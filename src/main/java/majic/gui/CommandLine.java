package majic.gui;

import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.AbstractAction;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import majic.script.MajicParser;

/**
 * Where commands are typed. An accepted line is cleared away; a wrong one stays, is marked, and its message is shown
 * until the line is mended. Up and Down walk through earlier lines, Tab completes. While a line is checked for which files
 * are read, it cannot be changed; STOP is not for the command line alone.
 */
final class CommandLine extends JTextField {
    private static final long serialVersionUID = 1L;

    private final transient MajicParser parser;
    private final transient Consumer<String> hint;
    private final transient History history = new History();

    /**
     * An empty line.
     *
     * @param hint shows a message or the words to choose from, or nothing
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
        bind(KeyEvent.VK_UP, "older line", () -> show(history.older(getText())));
        bind(KeyEvent.VK_DOWN, "newer line", () -> show(history.newer(getText())));
        bind(KeyEvent.VK_TAB, "complete", this::complete);
        getDocument().addDocumentListener(new Mending());
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
        ask(() -> parser.parseText(line), wrong -> entered(line, wrong));
    }

    /** Has the parser do something; beside the window, with the line held, if it has to look at files for it. */
    private <T> void ask(Supplier<T> question, Consumer<T> answer) {
        if (!isEditable()) {
            return;
        }
        if (!MajicParser.readsFiles(getText())) {
            answer.accept(question.get());
            return;
        }
        setEditable(false);
        Edt.background("reading for the command line", () -> {
            T told = question.get();
            Edt.later(() -> {
                setEditable(true);
                answer.accept(told);
            });
        });
    }

    private void entered(String line, Optional<String> wrong) {
        if (wrong.isEmpty()) {
            history.add(line);
            setText("");
        } else {
            putClientProperty("JComponent.outline", "error");
            hint.accept(wrong.get());
        }
    }

    private void complete() {
        if (getText().isBlank()) {
            transferFocus();
            return;
        }
        String text = getText();
        int caret = getCaretPosition();
        ask(() -> parser.complete(text, caret), words -> complete(Completer.complete(text, caret, words)));
    }

    private void complete(Completer done) {
        if (!done.text().equals(getText())) {
            setText(done.text());
        }
        setCaretPosition(done.caret());
        hint.accept(String.join("   ", done.choices()));
    }

    private void show(String line) {
        if (isEditable()) {
            setText(line);
        }
    }

    /** Takes the mark away as soon as the line is touched. */
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

        private void unmark() {
            putClientProperty("JComponent.outline", null);
            hint.accept("");
        }
    }
}
