package majic.gui.editor;

import java.awt.BorderLayout;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import javax.swing.JPanel;
import majic.gui.kit.TextChange;
import majic.script.ScriptRunner;
import majic.script.ScriptRunner.Checked;
import majic.script.run.ScriptControl.Progress;
import majic.script.syntax.Mistake;
import majic.team.Member;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;

/** One script in the editor: its text, its mistakes, its file and its run. */
final class EditorTab extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(EditorTab.class);

    private final ScriptArea area;
    private final FileNotice notice = new FileNotice();
    private final FindBar find;
    private final MistakeList mistakes;
    private final ValueTable values = new ValueTable();
    private final transient ScriptRunner runner;
    private final transient BackgroundCheck check;
    private final transient TabFile file;
    private final transient TabRun run;
    private final transient Runnable changed;
    private transient @Nullable Checked checked;

    /**
     * Creates a tab.
     *
     * @param script the script
     * @param exists whether the script's file was read, and not only named
     * @param changed called after each change of what the window shows of it
     */
    EditorTab(EditorContext context, ScriptRunner runner, ScriptFile script, boolean exists, Runnable changed) {
        super(new MigLayout("insets 0, gap 0, hidemode 3, wrap 1", "[grow, fill]"));
        this.changed = changed;
        this.runner = runner;
        area = new ScriptArea(runner);
        find = new FindBar(area.text());
        mistakes = new MistakeList(mistake -> area.goTo(mistake.line(), mistake.column()));
        file = new TabFile(this, context, script, exists);
        run = new TabRun(this, runner);
        check = new BackgroundCheck(runner, this::text, this::show);
        add(notice, "wmin 0");
        JPanel middle = new JPanel(new BorderLayout());
        middle.add(area, BorderLayout.CENTER);
        middle.add(values, BorderLayout.EAST);
        add(middle, "wmin 0, hmin 0, pushy, growy");
        add(find, "wmin 0");
        add(mistakes, "wmin 0");
        file.showText();
        area.text().getDocument().addDocumentListener(new TextChange(this::edited));
        area.text().addCaretListener(event -> changed());
        check.now();
    }

    ScriptArea area() {
        return area;
    }

    FileNotice notice() {
        return notice;
    }

    FindBar find() {
        return find;
    }

    TabFile file() {
        return file;
    }

    TabRun run() {
        return run;
    }

    String text() {
        return area.text().getText();
    }

    /** Shows another text; the present one can be brought back by undoing. */
    void replaceText(String text) {
        boolean first = checked == null;
        int caret = Math.min(area.text().getCaretPosition(), text.length());
        area.text().setText(text);
        area.text().setCaretPosition(first ? 0 : caret);
        if (first) {
            area.text().discardAllEdits();
        }
    }

    /** Whether it is a new script without text. */
    boolean isUntouched() {
        return file.path().isEmpty() && text().isEmpty() && !run.isRunning();
    }

    /** Shows where the script is, and while it is paused the values of its names. */
    void show(Progress progress) {
        area.show(progress);
        values.show(progress.paused() && !progress.isOver() ? progress.values() : List.of());
    }

    /** Ends what the tab does by itself. */
    void close() {
        run.close();
    }

    private void edited() {
        checkSoon();
        changed();
    }

    /** Reports a change to the window. */
    void changed() {
        changed.run();
    }

    /** Checks the script again, because it or the team has changed. */
    void checkSoon() {
        check.soon();
    }

    private void show(Checked found) {
        checked = found;
        area.showProcedures(Set.copyOf(runner.names(text(), 1).procedures().names()));
        area.show(found.mistakes());
        mistakes.show(found.mistakes());
        changed();
    }

    /** Returns the name with a sign for unsaved changes and for a run. */
    String title() {
        String sign = run.isRunning() ? "\u25B6 " : "";
        return sign + file.name() + (file.isModified() ? " \u2022" : "");
    }

    /** Returns which robots the script commands, as known since the last check. */
    String robots() {
        Checked known = checked;
        if (known == null) {
            return "";
        }
        List<Member> robots = known.robots().stream()
                .sorted(Comparator.comparingInt(Member::number))
                .toList();
        return robots.isEmpty()
                ? TEXTS.get("robots.none")
                : robots.stream()
                        .map(robot -> robot.number() + " " + robot.label())
                        .collect(Collectors.joining(", "));
    }

    /** Returns a sentence on the run, or on the mistakes while it does not run. */
    String status() {
        Progress progress = run.progress();
        if (run.isRunning()) {
            return running(progress);
        }
        List<Mistake> wrong = checked == null ? List.of() : checked.mistakes();
        if (!wrong.isEmpty()) {
            return TEXTS.get("status.mistakes", wrong.size());
        }
        return progress.isOver()
                ? TEXTS.get("status.lastRun", progress.outcome())
                : checked == null ? "" : TEXTS.get("status.noMistakes");
    }

    private static String running(Progress progress) {
        int count = progress.running().size();
        String lines = progress.running().stream().map(String::valueOf).collect(Collectors.joining(", "));
        if (progress.next().isPresent()) {
            int next = progress.next().getAsInt();
            return count == 0 ? TEXTS.get("status.paused", next) : TEXTS.get("status.pausedLines", next, count, lines);
        }
        if (progress.paused()) {
            return count == 0 ? TEXTS.get("status.pausing") : TEXTS.get("status.pausingLines", count, lines);
        }
        return count == 0 ? TEXTS.get("status.running") : TEXTS.get("status.runningLines", count, lines);
    }
}
