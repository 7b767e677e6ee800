package majic.gui.editor;

import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.gui.kit.NamedLabel;
import majic.gui.kit.Palette;
import majic.text.ErrorWords;
import net.miginfocom.swing.MigLayout;

/** A bar above a script with a notice about its file, and with buttons to act on it. Hidden while there is none. */
final class FileNotice extends JPanel {
    private static final long serialVersionUID = 1L;

    private final JLabel words = new NamedLabel("fileNotice", "");
    private final JPanel buttons = new JPanel(new MigLayout("insets 0, gap 6"));

    /**
     * What a bar offers.
     *
     * @param name of its button, for tests
     */
    record Choice(String name, String text, Runnable action) {}

    FileNotice() {
        super(new MigLayout("insets 4 10 4 8", "[grow, fill][]"));
        buttons.setOpaque(false);
        add(words, "wmin 0");
        add(buttons);
        setVisible(false);
    }

    /** Shows a notice in place of the one before; a choice hides it. */
    void show(String notice, Choice... choices) {
        words.setText(ErrorWords.of(notice));
        words.setToolTipText(words.getText());
        buttons.removeAll();
        for (Choice choice : choices) {
            JButton button = new JButton(choice.text());
            button.setName(choice.name());
            button.addActionListener(event -> {
                setVisible(false);
                choice.action().run();
            });
            buttons.add(button);
        }
        setBackground(Palette.mixed(0.12));
        setBorder(BorderFactory.createMatteBorder(0, 0, 1, 0, Palette.mixed(0.25)));
        setVisible(true);
        revalidate();
    }
}
