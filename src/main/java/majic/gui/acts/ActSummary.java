package majic.gui.acts;

import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.gui.kit.NamedLabel;
import majic.gui.kit.Palette;
import majic.gui.kit.Paragraph;
import net.miginfocom.swing.MigLayout;

/** Describes the selected act, beside the list of acts. */
final class ActSummary extends JPanel {
    private static final long serialVersionUID = 1L;

    private final JLabel title = new NamedLabel("actTitle", "");
    private final JLabel origin = new NamedLabel("actOrigin", "");
    private final Paragraph description = new Paragraph("actDescription", 1, 34);
    private final Paragraph note = new Paragraph("actNote", 1, 34);

    ActSummary() {
        super(new MigLayout("insets 0, gap 0 6, wrap 1, hidemode 3", "[grow, fill]", ""));
        title.putClientProperty("FlatLaf.styleClass", "h3");
        add(title, "wmin 0");
        add(origin, "wmin 0");
        add(description, "wmin 0");
        add(note, "wmin 0");
    }

    void show(ActEntry entry, Optional<String> unfit) {
        title.setText(entry.name());
        origin.setText(entry.origin());
        origin.setVisible(!entry.origin().isEmpty());
        origin.setForeground(Palette.faint());
        description.show(entry.description(), false);
        note.show(unfit.orElse(entry.note()), unfit.isPresent());
    }

    /** Shows a text that is not about an act. */
    void say(String words) {
        clear();
        note.setText("");
        description.show(words, false);
    }

    /** Shows an error. */
    void complain(String words) {
        clear();
        note.show(words, true);
    }

    private void clear() {
        title.setText("");
        origin.setText("");
        description.setText("");
    }
}
