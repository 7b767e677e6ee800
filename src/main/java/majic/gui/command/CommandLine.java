package majic.gui.command;

import java.awt.Graphics;
import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import javax.swing.JPopupMenu;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import majic.gui.kit.ClosesByEsc;
import majic.gui.kit.EventThread;
import majic.gui.kit.TextChange;
import majic.panel.KeyAction;
import majic.script.MajicParser;
import majic.script.Refusal;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * The field where commands are typed. An accepted line is removed; a wrong one stays with the wrong word selected and
 * underlined, and its error message is shown until the line is changed. A popup completes what is typed; Up and Down
 * recall earlier lines, Ctrl R searches them. The line can be edited at all times: files that a line names are read on
 * another thread, and if it is refused because of them it returns only if nothing has been typed since.
 */
public final class CommandLine extends JTextField implements ClosesByEsc {
    private static final Texts TEXTS = Texts.of(CommandLine.class);
    private static final String NAME = "NAME";
    private static final long serialVersionUID = 1L;

    /** A key that follows the return of a refused line sooner than this was typed for a new line. */
    private static final long NEW_LINE_WITHIN_MS = 700;

    private final transient MajicParser parser;
    private final transient Consumer<String> hint;
    private final transient Consumer<String> openScript;
    private transient Runnable submitted = () -> {};
    private final transient History history = new History();
    private final transient @Nullable HistoryFile file;
    private final transient KeysHeldElsewhere heldKeys = new KeysHeldElsewhere(this);
    private final transient TypingToLine typing = new TypingToLine(this);
    private final transient WrongWord wrongWord = new WrongWord(this);
    private final transient LineChoices choices;
    private transient @Nullable RefusedLater refusedLater;
    private transient @Nullable Correction correction;
    private @Nullable LineMenu menu;
    private String shownHint = "";
    private boolean putting;
    private boolean movedOn;
    private long newLineUntilMs;

    private record RefusedLater(String line, Refusal why) {}

    /**
     * Creates an empty line.
     *
     * @param file where earlier lines are kept; null if they are not kept
     * @param hint shows a message; for an empty text, what the keys do
     * @param openScript opens lines in the script editor
     */
    CommandLine(MajicParser parser, @Nullable HistoryFile file, Consumer<String> hint, Consumer<String> openScript) {
        this.parser = parser;
        this.file = file;
        this.hint = hint;
        this.openScript = openScript;
        choices = new LineChoices(this, parser, history, this::hint);
        choices.onChange(() -> hint(shownHint));
        setName("commandLine");
        getAccessibleContext().setAccessibleName(TEXTS.get("line"));
        putClientProperty("JTextField.placeholderText", TEXTS.get("line.example"));
        putClientProperty("JTextField.selectAllOnFocusPolicy", "never");
        setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, Set.of());
        addActionListener(event -> enter());
        bind("UP", this::up);
        bind("DOWN", this::down);
        bind("TAB", this::tab);
        bind("ESCAPE", this::escape);
        bind("ctrl R", this::searchOrNext);
        bind("ctrl U", this::empty);
        getDocument().addDocumentListener(new TextChange(this::changed));
        addCaretListener(event -> {
            if (!putting) {
                choices.caretMoved();
            }
        });
        if (file != null) {
            file.read(history::addOlder);
        }
    }

    /** Sets what runs when Enter has submitted a line, also one that is refused. */
    void onSubmit(Runnable listener) {
        submitted = listener;
    }

    /** Keeps the newest messages in view while the popup is open. */
    void leaveInView(MessageArea messages) {
        choices.leaveInView(messages);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setFont(UIManager.getFont("monospaced.font"));
    }

    @Override
    public void addNotify() {
        super.addNotify();
        heldKeys.install();
        typing.install();
    }

    @Override
    public void removeNotify() {
        typing.remove();
        heldKeys.remove();
        super.removeNotify();
    }

    /** Creates the context menu when it is first opened. */
    @Override
    public JPopupMenu getComponentPopupMenu() {
        LineMenu present = menu;
        if (present == null) {
            present = new LineMenu(this);
            menu = present;
        }
        return present;
    }

    private void bind(String key, Runnable action) {
        KeyAction.bind(this, WHEN_FOCUSED, KeyStroke.getKeyStroke(key), event -> action.run());
    }

    private void hint(String text) {
        shownHint = text;
        hint.accept(text);
    }

    /** Returns what the keys do now: with a text in the line, Esc and Ctrl U too. */
    String keys() {
        return TEXTS.get(getText().isBlank() ? "keys" : choices.isShowing() ? "keys.list" : "keys.text");
    }

    private void enter() {
        if (choices.isSearching()) {
            choices.take();
        } else if (!choices.useChosen()) {
            run(getText());
        }
    }

    private void run(String line) {
        choices.close();
        movedOn = false;
        Optional<Refusal> refusal = submit(line);
        if (refusal.isPresent()) {
            mark(refusal.get());
        } else {
            put(new CompletedLine("", 0));
        }
    }

    /**
     * Submits a line, which may have been typed elsewhere, and remembers it if it is accepted.
     *
     * @return why it is refused; empty if it is accepted
     */
    public Optional<Refusal> submit(String line) {
        Optional<Refusal> refusal = line.isBlank()
                ? Optional.empty()
                : parser.submit(line, why -> EventThread.later(() -> refusedLater(line, why)));
        if (refusal.isEmpty()) {
            remember(line);
        }
        submitted.run();
        return refusal;
    }

    /** Inserts a text in place of the selection. Several lines are not joined: what to do with them is asked. */
    @Override
    public void replaceSelection(@Nullable String text) {
        List<String> lines = text == null ? List.of() : text.lines().toList();
        List<String> commands = lines.stream().filter(line -> !line.isBlank()).toList();
        Window owner = SwingUtilities.getWindowAncestor(this);
        if (commands.size() > 1 && owner != null) {
            choices.close();
            new PastedLines(owner, lines, () -> runAll(commands), () -> openScript.accept(String.join("\n", lines)))
                    .setVisible(true);
        } else {
            super.replaceSelection(commands.size() == 1 ? commands.get(0) : text);
        }
    }

    /** Runs lines one after the other; one that is refused comes into the line, and those behind it are not run. */
    private void runAll(List<String> lines) {
        history.add(getText());
        put(new CompletedLine("", 0));
        for (int index = 0; index < lines.size(); index++) {
            String line = lines.get(index);
            Optional<Refusal> refusal = submit(line);
            if (refusal.isPresent()) {
                int left = lines.size() - index - 1;
                put(new CompletedLine(line, line.length()));
                mark(refusal.get());
                hint(left == 0 ? shownHint : TEXTS.get("line.rest", shownHint, left));
                return;
            }
        }
    }

    /** Empties the line, and closes what is open. */
    private void empty() {
        choices.close();
        movedOn = true;
        put(new CompletedLine("", 0));
    }

    private void remember(String line) {
        history.add(line);
        if (file != null && !line.isBlank()) {
            file.append(line);
        }
    }

    /**
     * Brings a line back that was refused after its files were read, unless another one has been begun or Esc was
     * pressed; Up recalls it then.
     */
    private void refusedLater(String line, Refusal why) {
        if (movedOn || !getText().isEmpty()) {
            history.add(line);
            refusedLater = new RefusedLater(line, why);
            hint(TEXTS.get("line.refused", why.message()));
        } else {
            put(new CompletedLine(line, line.length()));
            mark(why);
            newLineUntilMs = System.currentTimeMillis() + NEW_LINE_WITHIN_MS;
        }
    }

    /** Begins a new line with a key that was typed before the return of a refused line could be noticed. */
    @Override
    protected void processKeyEvent(KeyEvent event) {
        boolean character = !Character.isISOControl(event.getKeyChar()) && !event.isActionKey();
        if (character && event.getID() == KeyEvent.KEY_TYPED && event.getWhen() < newLineUntilMs) {
            put(new CompletedLine("", 0));
        }
        if (event.getID() == KeyEvent.KEY_TYPED || (!character && event.getID() == KeyEvent.KEY_PRESSED)) {
            newLineUntilMs = 0;
        }
        super.processKeyEvent(event);
    }

    /** Replaces the text, as the keys of history and completion do. */
    void put(CompletedLine line) {
        putting = true;
        try {
            setText(line.text());
            setCaretPosition(line.caret());
        } finally {
            putting = false;
        }
        unmark();
    }

    /**
     * Puts a line there whose word {@code NAME} is selected, so that typing replaces it; without that word the caret is
     * at its end.
     *
     * @param line a command, or its beginning
     */
    public void propose(String line) {
        int name = line.indexOf(NAME);
        int end = name < 0 ? line.length() : name + NAME.length();
        put(new CompletedLine(line, end));
        select(name < 0 ? end : name, end);
        requestFocusInWindow();
    }

    private void up() {
        if (!choices.move(-1)) {
            recallOlder();
        }
    }

    private void down() {
        if (!choices.move(1)) {
            recallNewer();
        }
    }

    void recallOlder() {
        recall(history.older(getText()));
    }

    void recallNewer() {
        recall(history.newer(getText()));
    }

    private void recall(String line) {
        choices.close();
        put(new CompletedLine(line, line.length()));
        RefusedLater refused = refusedLater;
        if (refused != null && refused.line().equals(line)) {
            mark(refused.why());
        }
    }

    private void tab() {
        boolean used = choices.useChosen();
        if (!used && getText().isBlank()) {
            transferFocus();
        } else if (!used) {
            choices.complete();
        }
    }

    /** Begins to search the earlier commands, or goes on to the next one that is found. */
    void searchOrNext() {
        if (!choices.isSearching()) {
            unmark();
        }
        choices.searchOrNext();
    }

    /** Closes the popup or removes the mark, and drops what was asked for, so that nothing appears after Esc. */
    private void escape() {
        movedOn = true;
        if (!choices.isShowing()) {
            unmark();
        }
        choices.close();
    }

    /** Returns whether the popup is open or the line is marked as wrong; Esc closes the popup or removes the mark. */
    @Override
    public boolean hasToClose() {
        return choices.isShowing() || getClientProperty("JComponent.outline") != null;
    }

    /** Removes the mark and its message; the text stays. */
    private void unmark() {
        putClientProperty("JComponent.outline", null);
        wrongWord.set(0, 0);
        correction = null;
        hint("");
    }

    private void mark(Refusal why) {
        putClientProperty("JComponent.outline", "error");
        wrongWord.set(why.from(), why.to());
        if (why.isLineRight()) {
            selectAll();
        } else {
            select(why.from(), why.to());
            correction = Correction.of(getText(), why);
        }
        hint(why.message());
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        wrongWord.paint(graphics);
    }

    private void changed() {
        if (!putting) {
            movedOn = true;
            Correction begun = correction;
            unmark();
            correction = begun;
            choices.textChanged();
        }
    }

    /** Removes the rest of a refused line once what is typed over its wrong word is seen to be a new line. */
    void dropRefused() {
        Correction begun = correction;
        if (begun != null) {
            begun.newLine(parser, getText(), getCaretPosition())
                    .ifPresent(line -> put(new CompletedLine(line, line.length())));
        }
    }
}
