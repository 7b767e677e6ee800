package majic.gui.command;

import java.nio.file.Path;
import java.util.function.Consumer;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.gui.kit.Palette;
import majic.gui.kit.ProgramServices;
import majic.script.MajicParser;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Holds the message area, the command line, and below it the line's error or a hint. */
public final class CommandPane extends JPanel {
    private static final Texts TEXTS = Texts.of(CommandPane.class);
    private static final long serialVersionUID = 1L;

    private final MessagePane messages;
    private final JLabel hint = new JLabel();
    private final CommandLine line;

    /**
     * Creates an empty pane.
     *
     * @param services the settings, and the file of the lines typed earlier
     * @param alarm reports a problem with that file; called on the event dispatch thread
     */
    public CommandPane(MajicParser parser, ProgramServices services, Consumer<String> alarm) {
        super(new MigLayout("insets 0, gap 4 4", "[][grow, fill]", "[grow, fill][][]"));
        Path history = services.history();
        line = new CommandLine(parser, history == null ? null : new HistoryFile(history, alarm), this::showHint);
        messages = new MessagePane(services.settings(), line::requestFocusInWindow);
        line.leaveInView(messages.area());
        hint.setName("hint");
        JLabel prompt = new JLabel(TEXTS.get("prompt"));
        prompt.setLabelFor(line);
        prompt.setDisplayedMnemonic(prompt.getText().charAt(0));
        add(messages, "spanx 2, grow, wrap");
        add(prompt);
        add(line, "wrap");
        add(hint, "skip 1, wmin 0");
        showHint("");
    }

    public MessageArea messages() {
        return messages.area();
    }

    public CommandLine line() {
        return line;
    }

    /** Shows a hint; an empty one keeps its space, so that the layout does not change. */
    private void showHint(String text) {
        boolean wrong = "error".equals(line == null ? null : line.getClientProperty("JComponent.outline"));
        hint.setForeground(wrong ? Palette.error() : Palette.text());
        hint.setText(text.isEmpty() ? TEXTS.get("keys") : text);
        hint.setToolTipText(text.isEmpty() ? null : text);
        hint.setEnabled(!text.isEmpty());
    }
}
