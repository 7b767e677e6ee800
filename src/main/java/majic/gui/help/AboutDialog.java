package majic.gui.help;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Window;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import majic.gui.kit.MajicDialog;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Shows the version of MAJIC, the Java that runs it, its licence, and the licences of the libraries in it. */
public final class AboutDialog extends MajicDialog {
    private static final Texts TEXTS = Texts.of(AboutDialog.class);
    private static final long serialVersionUID = 1L;
    private static final int SCROLL_BAR = 20;

    public AboutDialog(Window owner) {
        super(owner, TEXTS.get("about"));
        JPanel content =
                new JPanel(new MigLayout("insets 0, gap 0 4, wrap 1", "[grow, fill]", "[][][]10[][grow, fill]"));
        JLabel title = new JLabel("MAJIC " + version());
        title.setName("aboutVersion");
        title.putClientProperty("FlatLaf.styleClass", "h2");
        content.add(title);
        content.add(new JLabel(TEXTS.get("about.purpose")));
        content.add(new JLabel(TEXTS.get("about.java", Runtime.version(), System.getProperty("os.name"))));
        JTable table =
                new JTable(HelpTables.file("libraries", TEXTS.get("libraries.name"), TEXTS.get("libraries.licence")));
        table.setName("libraries");
        table.setShowHorizontalLines(true);
        TableColumns.fit(table);
        JScrollPane rows = new JScrollPane(table);
        rows.setPreferredSize(
                new Dimension(TableColumns.widthOf(table) + UIScale.scale(SCROLL_BAR), UIScale.scale(260)));
        content.add(label(TEXTS.get("libraries"), table));
        content.add(rows);
        fill(content, closing(TEXTS.get("close")));
    }

    private static String version() {
        String version = AboutDialog.class.getPackage().getImplementationVersion();
        return version == null ? TEXTS.get("about.noVersion") : version;
    }
}
