package majic.gui.command;

import java.awt.Window;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.MajicDialog;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Asks what to do with several lines that were pasted into the command line, and shows them. */
final class PastedLines extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(PastedLines.class);
    private static final int MOST_ROWS = 12;
    private static final int COLUMNS = 60;

    /**
     * Creates the dialog.
     *
     * @param lines what was pasted
     * @param run runs the lines one after the other
     * @param edit opens them in the script editor
     */
    PastedLines(Window owner, List<String> lines, Runnable run, Runnable edit) {
        super(owner, TEXTS.get("pasted"));
        HelpTopic.set(getRootPane(), "passing-commands");
        JTextArea text = new JTextArea(String.join("\n", lines), Math.min(MOST_ROWS, lines.size()), COLUMNS);
        text.setName("pastedLines");
        text.setEditable(false);
        text.setFont(UIManager.getFont("monospaced.font"));
        text.setCaretPosition(0);
        JLabel question = new JLabel(TEXTS.get(
                "pasted.question",
                lines.stream().filter(line -> !line.isBlank()).count()));
        question.setLabelFor(text);
        JPanel content = new JPanel(new MigLayout("insets 0, gap 8, wrap 1", "[grow, fill]", "[][grow, fill]"));
        content.add(question);
        content.add(new JScrollPane(text));
        JButton first = answer("pasted.run", run);
        fill(content, first, answer("pasted.edit", edit), closing(TEXTS.get("pasted.cancel")));
        focusFirst(first);
    }

    private JButton answer(String key, Runnable action) {
        JButton button = button(TEXTS.get(key), () -> {
            dispose();
            action.run();
        });
        button.setName(key);
        return button;
    }
}
