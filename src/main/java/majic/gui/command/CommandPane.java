package majic.gui.command;

import java.awt.BorderLayout;
import java.nio.file.Path;
import java.util.function.Consumer;
import javax.swing.GroupLayout;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.gui.kit.Palette;
import majic.gui.kit.ProgramServices;
import majic.script.MajicParser;
import majic.script.run.Questions;
import majic.text.Texts;

/** Holds the message area, the questions of scripts, the command line, and below it the line's error or a hint. */
public final class CommandPane extends JPanel {
    private static final Texts TEXTS = Texts.of(CommandPane.class);
    private static final long serialVersionUID = 1L;

    private static final int GAP = 4;

    private final MessagePane messages;
    private final JLabel hint = new JLabel();
    private final CommandLine line;
    private final JPanel bottom = new JPanel(new BorderLayout(0, GAP));

    /**
     * Creates an empty pane.
     *
     * @param services the settings, and the file of the lines typed earlier
     * @param alarm reports a problem with that file; called on the event dispatch thread
     * @param openScript opens lines in the script editor
     */
    public CommandPane(
            MajicParser parser, ProgramServices services, Consumer<String> alarm, Consumer<String> openScript) {
        super(new BorderLayout(0, GAP));
        Path history = services.history();
        HistoryFile file = history == null ? null : new HistoryFile(history, alarm);
        line = new CommandLine(parser, file, this::showHint, openScript);
        messages = new MessagePane(services.settings(), line::requestFocusInWindow);
        line.leaveInView(messages.area());
        line.onSubmit(messages.area()::showNewest);
        hint.setName("hint");
        JLabel prompt = new JLabel(TEXTS.get("prompt"));
        prompt.setLabelFor(line);
        prompt.setDisplayedMnemonic(prompt.getText().charAt(0));
        add(messages, BorderLayout.CENTER);
        bottom.add(withHint(prompt), BorderLayout.CENTER);
        add(bottom, BorderLayout.SOUTH);
        showHint("");
    }

    /** Places the line beside its prompt, and the hint below the line, however long the hint is. */
    private JPanel withHint(JLabel prompt) {
        JPanel panel = new JPanel();
        GroupLayout layout = new GroupLayout(panel);
        panel.setLayout(layout);
        GroupLayout.Group lineAndHint = layout.createParallelGroup()
                .addComponent(line, 0, GroupLayout.DEFAULT_SIZE, Short.MAX_VALUE)
                .addComponent(hint, 0, GroupLayout.DEFAULT_SIZE, Short.MAX_VALUE);
        layout.setHorizontalGroup(
                layout.createSequentialGroup().addComponent(prompt).addGap(GAP).addGroup(lineAndHint));
        layout.setVerticalGroup(layout.createSequentialGroup()
                .addGroup(layout.createParallelGroup(GroupLayout.Alignment.BASELINE)
                        .addComponent(prompt)
                        .addComponent(line))
                .addGap(GAP)
                .addComponent(hint));
        return panel;
    }

    /**
     * Adds what would have delayed the window; to be called when that was painted.
     *
     * @param questions of scripts, shown above the line
     */
    public void complete(Questions questions) {
        messages.complete();
        bottom.add(new QuestionStrip(questions, line::submit, line::requestFocusInWindow), BorderLayout.NORTH);
    }

    public MessageArea messages() {
        return messages.area();
    }

    public CommandLine line() {
        return line;
    }

    /** Shows a hint; an empty one keeps its space, so that the layout does not change. */
    private void showHint(String text) {
        boolean wrong = "error".equals(line.getClientProperty("JComponent.outline"));
        hint.setForeground(wrong ? Palette.error() : Palette.text());
        hint.setText(text.isEmpty() ? line.keys() : text);
        hint.setToolTipText(text.isEmpty() ? null : text);
        hint.setEnabled(!text.isEmpty());
    }
}
