package majic.gui.acts;

import java.awt.Color;
import java.awt.Font;
import java.awt.Window;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import majic.act.file.ActFile;
import majic.act.file.Signer;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.NamedLabel;
import majic.gui.kit.Palette;
import majic.gui.kit.Paragraph;
import majic.text.Texts;
import majic.text.VisibleText;
import net.miginfocom.swing.MigLayout;

/** Shows what code an act contains, before any of it is loaded, and asks whether it may run. Enter refuses. */
final class TrustDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(TrustDialog.class);

    /** Number of characters of the title that fit into the dialog's width. */
    private static final int LINE = 80;

    /**
     * Creates the dialog, not yet shown.
     *
     * @param agreed runs when the user agrees; otherwise nothing is done
     */
    TrustDialog(Window owner, ActFile file, Runnable agreed) {
        super(owner, TEXTS.get("trust"));
        HelpTopic.set(getRootPane(), "loading-acts");
        JPanel facts = new JPanel(new MigLayout("insets 0, gap 12 6", "[right][520:600:, grow, fill]", ""));
        facts.add(title(file.details().name()), "spanx 2, growx, wmin 0, gapbottom 4, wrap");
        row(facts, TEXTS.get("file"), file.label(), "trustFile");
        row(facts, TEXTS.get("ofAuthor"), author(file), "trustAuthor");
        lines(facts, TEXTS.get("signature"), signature(file.signers()), "trustSignature");
        mono(row(facts, "SHA-256", file.sha256(), "trustHash"));
        lines(facts, TEXTS.get("classes"), file.classes(), "trustClasses");
        lines(facts, TEXTS.get("packages"), file.packages(), "trustPackages");
        facts.add(consequence(), "spanx 2, growx, wmin 0, gaptop 6");
        JButton no = closing(TEXTS.get("doNotRun"));
        focusFirst(no);
        fill(facts, no, button(TEXTS.get("agree"), () -> {
            dispose();
            agreed.run();
        }));
    }

    private static Paragraph title(String act) {
        String words = TEXTS.get("noConsent", act);
        Paragraph title = new Paragraph("trustTitle", 1 + words.length() / LINE, LINE / 2);
        title.putClientProperty("FlatLaf.styleClass", "h4");
        title.show(words, false);
        return title;
    }

    private static String author(ActFile file) {
        String author = file.details().author();
        return author.isEmpty() ? TEXTS.get("noAuthor") : TEXTS.get("authorInFile", author);
    }

    /**
     * Describes the signatures with their fingerprints: a name in a certificate proves nothing, but a fingerprint can
     * be compared with the one that the signer publishes.
     */
    private static List<String> signature(List<Signer> signers) {
        return signers.isEmpty()
                ? List.of(TEXTS.get("unsigned"))
                : signers.stream()
                        .flatMap(signer -> Stream.of(signer.name(), TEXTS.get("certificate", signer.fingerprint())))
                        .toList();
    }

    private static void mono(JLabel hash) {
        Font font = UIManager.getFont("monospaced.font");
        hash.setFont(font == null ? new Font(Font.MONOSPACED, Font.PLAIN, 12) : font);
    }

    private static Paragraph consequence() {
        Paragraph words = new Paragraph("trustConsequence", 3, 60);
        words.show(TEXTS.get("consequence"), false);
        Color line = Palette.mixed(0.3);
        words.setBorder(BorderFactory.createCompoundBorder(
                BorderFactory.createMatteBorder(1, 0, 0, 0, line), BorderFactory.createEmptyBorder(10, 0, 0, 0)));
        return words;
    }

    private static JLabel row(JPanel facts, String name, String text, String as) {
        JLabel value = new NamedLabel(as, text);
        facts.add(new JLabel(name));
        facts.add(value, "wmin 0, wrap");
        return value;
    }

    private static void lines(JPanel facts, String name, List<String> lines, String as) {
        List<String> seen = lines.stream().map(VisibleText::of).toList();
        if (seen.size() == 1) {
            row(facts, name, seen.get(0), as);
            return;
        }
        JTextArea area = new JTextArea(String.join("\n", seen));
        area.setName(as);
        area.setEditable(false);
        area.setRows(Math.min(5, Math.max(2, lines.size())));
        area.setCaretPosition(0);
        facts.add(label(name, area), "aligny top");
        facts.add(new JScrollPane(area), "wmin 0, wrap");
    }
}
