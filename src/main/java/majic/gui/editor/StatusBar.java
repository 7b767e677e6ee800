package majic.gui.editor;

import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.gui.kit.NamedLabel;
import majic.gui.kit.Palette;
import net.miginfocom.swing.MigLayout;

/** The line below a script: its mistakes or its run, what the word at the caret means, and where the caret is. */
final class StatusBar extends JPanel {
    private static final long serialVersionUID = 1L;

    private final JLabel status = new NamedLabel("scriptStatus", " ");
    private final JLabel hint = new NamedLabel("wordHint", "");
    private final JLabel place = new JLabel();

    StatusBar() {
        super(new MigLayout("insets 4 12 6 12, gap 24", "[shrinkprio 50][grow, fill, shrinkprio 200][]"));
        add(status, "wmin 0");
        add(hint, "wmin 0");
        add(place);
        hint.setForeground(Palette.faint());
    }

    /** Updates the colours for the look and feel. */
    @Override
    public void updateUI() {
        super.updateUI();
        if (hint != null) {
            hint.setForeground(Palette.faint());
        }
    }

    void show(EditorTab tab) {
        status.setText(tab.status());
        String words = tab.area().hint();
        hint.setText(words);
        hint.setToolTipText(words.isEmpty() ? null : words);
        place.setText(tab.area().caretPlace());
    }
}
