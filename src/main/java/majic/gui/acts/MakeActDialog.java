package majic.gui.acts;

import java.awt.Window;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JTextField;
import majic.act.ActDetails;
import majic.act.file.ActCatalog;
import majic.environment.Settings;
import majic.gui.kit.ChooseFile;
import majic.gui.kit.Confirm;
import majic.gui.kit.EventThread;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.Paragraph;
import majic.script.ActOffers;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;

/** Makes an act's file of classes, a jar, a source or a script. All work is done in the background. */
public final class MakeActDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(MakeActDialog.class);

    private final transient ActOffers offers;
    private final transient Settings settings;
    private final SuggestedField from = new SuggestedField("makeFrom");
    private final JComboBox<String> act = new JComboBox<>();
    private final SuggestedField name = new SuggestedField("makeName");
    private final JTextField version = new JTextField("1.0");
    private final JTextField author = new JTextField(System.getProperty("user.name", ""));
    private final JTextField description = new JTextField();
    private final SuggestedField target = new SuggestedField("makeTarget");
    private final Paragraph outcome = new Paragraph("makeOutcome", 4, 50);
    private final JButton make = button(TEXTS.get("make"), this::make);
    private transient @Nullable ActSource source;
    private String looked = "";

    public MakeActDialog(Window owner, ActOffers offers, Settings settings) {
        super(owner, TEXTS.get("makeAct"));
        HelpTopic.set(getRootPane(), "making-an-acts-file");
        this.offers = offers;
        this.settings = settings;
        act.setName("makeAct");
        version.setName("makeVersion");
        author.setName("makeAuthor");
        description.setName("makeDescription");
        from.addActionListener(event -> look());
        from.whenFocusIsLost(this::look);
        act.addActionListener(event -> suggestNames());
        name.whenFocusIsLost(this::suggestTarget);
        fill(content(), make, closing(TEXTS.get("close")));
        make.setEnabled(false);
        outcome.show(TEXTS.get("sources"), false);
    }

    private JPanel content() {
        JPanel panel = new JPanel(new MigLayout("insets 0, gap 10 8", "[right][360::, grow, fill][]", ""));
        row(
                panel,
                TEXTS.get("madeOf"),
                from,
                button(TEXTS.get("chooseSource"), () -> ChooseFile.toMakeOf(getOwner(), settings, this::chosen)));
        row(panel, TEXTS.get("act"), act, null);
        row(panel, TEXTS.get("name"), name, null);
        row(panel, TEXTS.get("ofVersion"), version, null);
        row(panel, TEXTS.get("ofAuthor"), author, null);
        row(panel, TEXTS.get("description"), description, null);
        row(panel, TEXTS.get("file"), target, button(TEXTS.get("saveAs"), this::chooseTarget));
        panel.add(outcome, "skip 1, spanx 2, growx, wmin 0, hmin 72, gaptop 4");
        return panel;
    }

    private static void row(JPanel panel, String label, JComponent field, @Nullable JButton choose) {
        panel.add(label(label, field));
        panel.add(field, choose == null ? "spanx 2, growx, wmin 0, wrap" : "wmin 0");
        if (choose != null) {
            panel.add(choose, "sizegroup c, wrap");
        }
    }

    /** Makes the act of this source, as if it had been chosen. */
    public void makeOf(Path source) {
        chosen(source);
    }

    private void chosen(Path file) {
        from.setText(file.toString());
        look();
    }

    private void chooseTarget() {
        ChooseFile.toName(
                getOwner(),
                settings,
                TEXTS.get("saveAs.title"),
                target.getText(),
                file -> target.setText(file.toString()));
    }

    /**
     * Finds the acts in the source if another path was entered, or if none was found before: the file may be mended.
     */
    private void look() {
        String path = from.getText().strip();
        if (path.equals(looked) && source != null) {
            return;
        }
        looked = path;
        source = null;
        act.removeAllItems();
        if (path.isEmpty()) {
            make.setEnabled(false);
            return;
        }
        work(TEXTS.get("looking"), () -> {
            ActSource found = ActSource.read(Path.of(path));
            return () -> found(path, found);
        });
    }

    private void found(String path, ActSource found) {
        if (path.equals(looked)) {
            source = found;
            act.removeAllItems();
            found.acts().forEach(act::addItem);
            make.setEnabled(true);
            outcome.show(found.acts().size() == 1 ? "" : TEXTS.get("several"), false);
        }
    }

    private void suggestNames() {
        if (act.getSelectedItem() instanceof String chosen) {
            name.suggest(ActSource.simpleName(chosen));
            suggestTarget();
        }
    }

    private void suggestTarget() {
        target.suggest(offers.folder() + File.separator + name.getText().strip() + ActCatalog.ENDING);
    }

    private void make() {
        String path = target.getText().strip();
        if (path.isEmpty()) {
            outcome.show(TEXTS.get("noFile"), true);
            return;
        }
        work(TEXTS.get("making"), () -> {
            Path file = Path.of(path);
            return Files.exists(file) ? () -> askToOverwrite(file) : () -> make(file);
        });
    }

    private void askToOverwrite(Path file) {
        outcome.show("", false);
        Confirm.ask(getOwner(), TEXTS.get("exists", file), TEXTS.get("overwrite"), () -> make(file));
    }

    private void make(Path file) {
        ActSource known = source;
        String chosen = (String) act.getSelectedItem();
        ActDetails details = new ActDetails(name.getText(), version.getText(), author.getText(), description.getText());
        if (known != null && chosen != null) {
            work(TEXTS.get("making"), () -> {
                String done = known.make(chosen, details, file);
                return () -> outcome.show(done, false);
            });
        }
    }

    /** Work that may block and fail. */
    private interface Work {
        Runnable done();
    }

    private void work(String doing, Work work) {
        make.setEnabled(false);
        outcome.show(doing, false);
        EventThread.background(
                "making an act",
                () -> {
                    Runnable done = work.done();
                    EventThread.later(() -> ended(done));
                },
                why -> ended(() -> outcome.show(why, true)));
    }

    private void ended(Runnable show) {
        make.setEnabled(source != null);
        show.run();
    }
}
